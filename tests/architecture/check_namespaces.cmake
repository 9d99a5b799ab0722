# cmake -D ROOT=DIR -P check_namespaces.cmake: fails where a program's file opens another namespace
# than its program's: `dem` itself is for what both share.
foreach(program shapegen runtime)
    file(GLOB_RECURSE sources ${ROOT}/${program}/*.hpp ${ROOT}/${program}/*.cpp)
    foreach(source ${sources})
        file(STRINGS ${source} lines REGEX "^[ \t]*(inline[ \t]+)?namespace[ \t]+dem")
        foreach(line ${lines})
            if(NOT line MATCHES "namespace[ \t]+dem::${program}[ \t:{]")
                message(SEND_ERROR "namespace of another: ${source}: ${line}")
            endif()
        endforeach()
    endforeach()
endforeach()
