#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <exception>
#include <string>

#include "support/error.hpp"
#include "support/files.hpp"
#include "support/image.hpp"

namespace support {
namespace {

Imf::Slice float_slice(const float* pixels, const Imath::Box2i& window) {
    return Imf::Slice::Make(Imf::FLOAT, pixels, window);
}

}  // namespace

const ExrChannel* find_channel(const ExrImage& image, const std::string& name) {
    for (const ExrChannel& channel : image.channels) {
        if (channel.name == name) {
            return &channel;
        }
    }
    return nullptr;
}

ExrImage read_exr(const std::filesystem::path& path) {
    read_file(path);  // for its message where the file cannot be read at all
    try {
        Imf::InputFile file(path.c_str());
        const Imath::Box2i window = file.header().dataWindow();
        ExrImage image{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}, {}, false};
        if (image.width > max_image_size || image.height > max_image_size) {
            throw std::runtime_error("larger than " + std::to_string(max_image_size) + " pixels on a side");
        }

        const Imf::ChannelList& channels = file.header().channels();
        for (Imf::ChannelList::ConstIterator i = channels.begin(); i != channels.end(); ++i) {
            if (i.channel().xSampling != 1 || i.channel().ySampling != 1) {
                throw std::runtime_error(std::string("channel ") + i.name() + " is subsampled");
            }
            const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
            image.channels.push_back(ExrChannel{i.name(), std::vector<float>(count)});
            image.half_float = i.channel().type == Imf::HALF;
        }
        Imf::FrameBuffer frame;
        for (ExrChannel& channel : image.channels) {
            frame.insert(channel.name, float_slice(channel.pixels.data(), window));
        }
        file.setFrameBuffer(frame);
        file.readPixels(window.min.y, window.max.y);

        for (Imf::Header::ConstIterator i = file.header().begin(); i != file.header().end(); ++i) {
            const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
            if (text != nullptr) {
                image.attributes[i.name()] = text->value();
            }
        }
        return image;
    } catch (const std::exception& error) {
        throw Error("'" + path.string() + "' is not a whole OpenEXR file (" + error.what() +
                    "); fetch it anew or give another");
    }
}

void write_exr(const std::filesystem::path& path, const ExrImage& image) {
    std::string bytes;
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (const auto& [name, text] : image.attributes) {
            header.insert(name, Imf::StringAttribute(text));
        }
        Imf::FrameBuffer frame;
        std::vector<std::vector<half>> rounded;  // OpenEXR writes what lies in memory, and converts nothing
        rounded.reserve(image.channels.size());
        for (const ExrChannel& channel : image.channels) {
            header.channels().insert(channel.name, Imf::Channel(image.half_float ? Imf::HALF : Imf::FLOAT));
            if (image.half_float) {
                rounded.emplace_back(channel.pixels.begin(), channel.pixels.end());
                frame.insert(channel.name,
                             Imf::Slice::Make(Imf::HALF, rounded.back().data(), header.dataWindow()));
            } else {
                frame.insert(channel.name, float_slice(channel.pixels.data(), header.dataWindow()));
            }
        }
        Imf::StdOSStream stream;
        {
            Imf::OutputFile file(stream, header);
            file.setFrameBuffer(frame);
            file.writePixels(image.height);
        }
        bytes = stream.str();
    } catch (const std::exception& error) {
        throw Error("cannot encode '" + path.string() + "' as OpenEXR: " + error.what() +
                    "; use a smaller image");
    }
    write_file(path, bytes);
}

}  // namespace support
