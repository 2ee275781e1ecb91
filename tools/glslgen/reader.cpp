#include "reader.hpp"

#include <clang-c/Index.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>

namespace glslgen {
namespace {

namespace fs = std::filesystem;

std::string take(CXString text) {
    const char* characters = clang_getCString(text);
    std::string result = characters ? characters : "";
    clang_disposeString(text);
    return result;
}

std::string canonical(const std::string& path) {
    std::error_code error;
    const fs::path result = fs::weakly_canonical(path, error);
    return error ? path : result.string();
}

struct Location {
    std::string file;
    unsigned line = 0;
    unsigned column = 0;
    unsigned offset = 0;
};

Location locate(CXSourceLocation location) {
    CXFile file = nullptr;
    Location result;
    clang_getFileLocation(location, &file, &result.line, &result.column, &result.offset);
    if (file) {
        result.file = canonical(take(clang_getFileName(file)));
    }
    return result;
}

void visit_children(CXCursor cursor, const std::function<void(CXCursor)>& visit) {
    const auto forward = [](CXCursor child, CXCursor, CXClientData data) {
        (*static_cast<const std::function<void(CXCursor)>*>(data))(child);
        return CXChildVisit_Continue;
    };
    clang_visitChildren(cursor, forward, const_cast<std::function<void(CXCursor)>*>(&visit));
}

struct Extent {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Extent extent(CXCursor cursor) {
    const CXSourceRange range = clang_getCursorExtent(cursor);
    return {locate(clang_getRangeStart(range)).offset, locate(clang_getRangeEnd(range)).offset};
}

std::string kind_name(CXCursor cursor) {
    return take(clang_getCursorKindSpelling(clang_getCursorKind(cursor)));
}

ParameterDeclaration read_parameter(CXCursor cursor, const std::string& text) {
    ParameterDeclaration parameter;
    parameter.name = take(clang_getCursorSpelling(cursor));
    parameter.type = take(clang_getTypeSpelling(clang_getCursorType(cursor)));
    parameter.line = locate(clang_getCursorLocation(cursor)).line;
    const Extent range = extent(cursor);
    parameter.has_default = text.substr(range.begin, range.end - range.begin).find('=') != std::string::npos;
    return parameter;
}

TemplateParameter read_template_parameter(CXCursor cursor) {
    TemplateParameter parameter;
    parameter.name = take(clang_getCursorSpelling(cursor));
    parameter.is_type = clang_getCursorKind(cursor) == CXCursor_TemplateTypeParameter;
    visit_children(cursor, [&](CXCursor child) {
        // A default of its own, or a template of the Scene: the first name says which.
        const CXCursorKind kind = clang_getCursorKind(child);
        if (parameter.default_type.empty() && (kind == CXCursor_TypeRef || kind == CXCursor_TemplateRef)) {
            parameter.default_type = take(clang_getCursorSpelling(clang_getCursorReferenced(child)));
        }
    });
    return parameter;
}

bool is_template_parameter(CXCursorKind kind) {
    return kind == CXCursor_TemplateTypeParameter || kind == CXCursor_NonTypeTemplateParameter ||
           kind == CXCursor_TemplateTemplateParameter;
}

template <typename Callable>
void read_callable(CXCursor cursor, const std::string& text, Callable& result) {
    result.result_type = take(clang_getTypeSpelling(clang_getCursorResultType(cursor)));
    visit_children(cursor, [&](CXCursor child) {
        const CXCursorKind kind = clang_getCursorKind(child);
        if (kind == CXCursor_ParmDecl) {
            result.parameters.push_back(read_parameter(child, text));
        } else if (kind == CXCursor_CompoundStmt) {
            const Extent body = extent(child);
            result.body_begin = body.begin;
            result.body_end = body.end;
        }
    });
}

MemberDeclaration read_member(CXCursor cursor, const std::string& text) {
    MemberDeclaration member;
    const CXCursorKind kind = clang_getCursorKind(cursor);
    member.what = kind_name(cursor);
    member.name = take(clang_getCursorSpelling(cursor));
    member.type = take(clang_getTypeSpelling(clang_getCursorType(cursor)));
    member.line = locate(clang_getCursorLocation(cursor)).line;
    const Extent range = extent(cursor);
    member.begin = range.begin;
    member.end = range.end;
    if (kind == CXCursor_FieldDecl) {
        member.kind = MemberDeclaration::Kind::field;
    } else if (kind == CXCursor_VarDecl) {
        member.kind = MemberDeclaration::Kind::constant;
    } else if (kind == CXCursor_CXXBaseSpecifier) {
        member.kind = MemberDeclaration::Kind::base;
    } else if (member.name == "operator()") {
        member.kind = MemberDeclaration::Kind::call_operator;
        read_callable(cursor, text, member);
    }
    return member;
}

/// An alias template of the C++ interface alone; every other declaration is read by its kind.
Declaration::Kind declaration_kind(CXCursor cursor, const std::string& text, const Extent& range) {
    switch (clang_getCursorKind(cursor)) {
        case CXCursor_TypeAliasTemplateDecl:
            return Declaration::Kind::alias;
        case CXCursor_VarDecl:
            return Declaration::Kind::variable;
        case CXCursor_StructDecl:
            return Declaration::Kind::record;
        case CXCursor_ClassTemplate:
            return Declaration::Kind::struct_template;
        case CXCursor_FunctionTemplate:
        case CXCursor_FunctionDecl:
            return Declaration::Kind::function;
        case CXCursor_UnexposedDecl:
            // libclang 14 has no kind of its own for a variable template.
            return text.compare(range.begin, 8, "template") == 0 ? Declaration::Kind::variable_template
                                                                 : Declaration::Kind::other;
        default:
            return Declaration::Kind::other;
    }
}

Declaration read_declaration(CXCursor cursor, const std::string& scope, const std::string& text) {
    Declaration result;
    const Extent range = extent(cursor);
    result.kind = declaration_kind(cursor, text, range);
    result.what = kind_name(cursor);
    result.name = take(clang_getCursorSpelling(cursor));
    result.scope = scope;
    result.line = locate(clang_getCursorLocation(cursor)).line;
    result.begin = range.begin;
    result.end = range.end;
    if (result.kind == Declaration::Kind::function) {
        read_callable(cursor, text, result);
    }
    visit_children(cursor, [&](CXCursor child) {
        if (is_template_parameter(clang_getCursorKind(child))) {
            result.template_parameters.push_back(read_template_parameter(child));
        } else if (result.kind == Declaration::Kind::struct_template ||
                   result.kind == Declaration::Kind::record) {
            result.members.push_back(read_member(child, text));
        }
    });
    return result;
}

std::string read_file(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw Failure("cannot read " + path + ": give the path of an existing header");
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class Reader {
  public:
    explicit Reader(const ReadOptions& options) : options_(options) {
        for (const std::string& folder : options.include_folders) {
            folders_.push_back(canonical(folder) + "/");
        }
        root_ = canonical(options.root);
    }

    ReadResult read() {
        read_file(root_);  // says what is wrong better than libclang does
        parse();
        collect_complaints();
        collect_preprocessing();
        add_header(root_);
        if (result_.complaints.empty()) {
            collect_declarations();
        }
        return std::move(result_);
    }

  private:
    struct IndexDeleter {
        void operator()(void* index) const {
            clang_disposeIndex(index);
        }
    };
    struct UnitDeleter {
        void operator()(CXTranslationUnitImpl* unit) const {
            clang_disposeTranslationUnit(unit);
        }
    };

    bool is_ours(const std::string& path) const {
        if (path == root_) {
            return true;
        }
        return std::any_of(folders_.begin(), folders_.end(),
                           [&](const std::string& folder) { return path.rfind(folder, 0) == 0; });
    }

    std::string shown(const std::string& path) const {
        for (std::size_t i = 0; i < folders_.size(); ++i) {
            if (path.rfind(folders_[i], 0) == 0) {
                const std::string folder = fs::path(folders_[i]).parent_path().filename().string();
                return folder + "/" + path.substr(folders_[i].size());
            }
        }
        return fs::path(path).filename().string();
    }

    void parse() {
        std::vector<std::string> arguments = {"-x", "c++", "-std=c++17", "-Wno-everything"};
        for (const std::string& folder : options_.include_folders) {
            arguments.push_back("-I" + folder);
        }
        for (const std::string& folder : options_.system_folders) {
            arguments.push_back("-I" + folder);  // -isystem /usr/include would hide it from #include_next
        }
        std::vector<const char*> pointers;
        for (const std::string& argument : arguments) {
            pointers.push_back(argument.c_str());
        }
        index_.reset(clang_createIndex(0, 0));
        CXTranslationUnit unit = nullptr;
        const CXErrorCode code = clang_parseTranslationUnit2(
            index_.get(), root_.c_str(), pointers.data(), static_cast<int>(pointers.size()), nullptr, 0,
            CXTranslationUnit_DetailedPreprocessingRecord, &unit);
        if (code != CXError_Success || !unit) {
            throw Failure("libclang could not parse " + root_);
        }
        unit_.reset(unit);
    }

    void collect_complaints() {
        const unsigned count = clang_getNumDiagnostics(unit_.get());
        for (unsigned i = 0; i < count; ++i) {
            const CXDiagnostic diagnostic = clang_getDiagnostic(unit_.get(), i);
            if (clang_getDiagnosticSeverity(diagnostic) >= CXDiagnostic_Error) {
                const Location where = locate(clang_getDiagnosticLocation(diagnostic));
                const std::string file = where.file.empty() ? root_ : where.file;
                result_.complaints.push_back(
                    {is_ours(file) ? shown(file) : file, where.line,
                     "does not compile: " + take(clang_getDiagnosticSpelling(diagnostic))});
            }
            clang_disposeDiagnostic(diagnostic);
        }
    }

    void collect_preprocessing() {
        visit_children(clang_getTranslationUnitCursor(unit_.get()), [&](CXCursor cursor) {
            const CXCursorKind kind = clang_getCursorKind(cursor);
            if (kind != CXCursor_InclusionDirective && kind != CXCursor_MacroExpansion) {
                return;
            }
            const Location where = locate(clang_getCursorLocation(cursor));
            if (where.file.empty() || !is_ours(where.file)) {
                return;
            }
            if (kind == CXCursor_MacroExpansion) {
                macro_uses_[where.file].push_back(
                    {take(clang_getCursorSpelling(cursor)), where.line, where.offset});
                return;
            }
            CXFile file = clang_getIncludedFile(cursor);
            const std::string target = file ? canonical(take(clang_getFileName(file))) : "";
            if (!target.empty() && is_ours(target)) {
                includes_[where.file].push_back({target, where.line});
            }
        });
    }

    /// Depth first, so that a header stands after everything it includes.
    void add_header(const std::string& path) {
        if (positions_.count(path) || open_.count(path)) {
            return;
        }
        open_.insert(path);
        Header header;
        header.name = fs::path(path).filename().string();
        header.stem = fs::path(path).stem().string();
        header.shown = shown(path);
        header.text = read_file(path);
        header.namespace_begin = header.text.size();
        header.macro_uses = macro_uses_[path];
        header.visible.insert(header.name);
        for (const Include& include : includes_[path]) {
            add_header(include.header);
            const auto position = positions_.find(include.header);
            if (position != positions_.end()) {
                const Header& included = result_.headers[position->second];
                header.includes.push_back({included.name, include.line});
                header.visible.insert(included.visible.begin(), included.visible.end());
            }
        }
        header.tokens = tokenize(path);
        positions_[path] = result_.headers.size();
        result_.headers.push_back(std::move(header));
    }

    std::vector<Token> tokenize(const std::string& path) {
        CXFile file = clang_getFile(unit_.get(), path.c_str());
        const unsigned size = static_cast<unsigned>(fs::file_size(path));
        const CXSourceRange range = clang_getRange(clang_getLocationForOffset(unit_.get(), file, 0),
                                                   clang_getLocationForOffset(unit_.get(), file, size));
        CXToken* tokens = nullptr;
        unsigned count = 0;
        clang_tokenize(unit_.get(), range, &tokens, &count);
        std::vector<Token> result;
        for (unsigned i = 0; i < count; ++i) {
            const CXSourceRange extent_of_token = clang_getTokenExtent(unit_.get(), tokens[i]);
            const Location begin = locate(clang_getRangeStart(extent_of_token));
            const Location end = locate(clang_getRangeEnd(extent_of_token));
            Token token;
            switch (clang_getTokenKind(tokens[i])) {
                case CXToken_Keyword:
                    token.kind = TokenKind::keyword;
                    break;
                case CXToken_Identifier:
                    token.kind = TokenKind::identifier;
                    break;
                case CXToken_Literal:
                    token.kind = TokenKind::literal;
                    break;
                case CXToken_Comment:
                    token.kind = TokenKind::comment;
                    break;
                case CXToken_Punctuation:
                    token.kind = TokenKind::punctuation;
                    break;
            }
            token.text = take(clang_getTokenSpelling(unit_.get(), tokens[i]));
            token.line = begin.line;
            token.column = begin.column;
            token.begin = begin.offset;
            token.end = end.offset;
            result.push_back(std::move(token));
        }
        clang_disposeTokens(unit_.get(), tokens, count);
        return result;
    }

    void collect_declarations() {
        visit_children(clang_getTranslationUnitCursor(unit_.get()), [&](CXCursor cursor) {
            const CXCursorKind kind = clang_getCursorKind(cursor);
            if (kind == CXCursor_InclusionDirective || kind == CXCursor_MacroExpansion ||
                kind == CXCursor_MacroDefinition) {
                return;
            }
            const Location where = locate(clang_getCursorLocation(cursor));
            const auto position = positions_.find(where.file);
            if (position == positions_.end()) {
                return;
            }
            Header& header = result_.headers[position->second];
            if (kind == CXCursor_Namespace && take(clang_getCursorSpelling(cursor)) == "airlight") {
                header.namespace_begin = std::min(header.namespace_begin, extent(cursor).begin);
                collect_namespace(cursor, "", header);
            } else {
                result_.complaints.push_back({header.shown, where.line,
                                              "'" + take(clang_getCursorSpelling(cursor)) +
                                                  "' stands outside namespace airlight: move it inside"});
            }
        });
    }

    void collect_namespace(CXCursor space, const std::string& scope, Header& header) {
        visit_children(space, [&](CXCursor cursor) {
            if (clang_getCursorKind(cursor) == CXCursor_Namespace) {
                collect_namespace(cursor, scope + take(clang_getCursorSpelling(cursor)) + "::", header);
                return;
            }
            header.declarations.push_back(read_declaration(cursor, scope, header.text));
        });
    }

    const ReadOptions& options_;
    std::string root_;
    std::vector<std::string> folders_;
    std::unique_ptr<void, IndexDeleter> index_;
    std::unique_ptr<CXTranslationUnitImpl, UnitDeleter> unit_;
    std::map<std::string, std::vector<Include>> includes_;
    std::map<std::string, std::vector<MacroUse>> macro_uses_;
    std::map<std::string, std::size_t> positions_;
    std::set<std::string> open_;
    ReadResult result_;
};

}  // namespace

ReadResult read_headers(const ReadOptions& options) {
    return Reader(options).read();
}

}  // namespace glslgen
