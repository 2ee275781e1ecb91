# airlight_target_defaults(<target>): what every target of this project is compiled with.
#
# -ffp-contract=off keeps a * b + c as two rounded operations, on every compiler alike. The parity test needs
# it: software GL rounds twice as well, so C++ float and the shader can agree to the bit.
function(airlight_target_defaults target)
    target_compile_features(${target} PRIVATE cxx_std_17)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise $<$<BOOL:${AIRLIGHT_WERROR}>:/WX>)
        return()
    endif()
    target_compile_options(
        ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off
                          $<$<BOOL:${AIRLIGHT_WERROR}>:-Werror>
    )
endfunction()
