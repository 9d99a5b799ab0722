# check_layer(TARGET ALLOW libraries...): stops the configuration when TARGET links anything else
# directly. Direct links are enough because every lower layer is checked too.
function(check_layer target)
    cmake_parse_arguments(ARG "" "" "ALLOW" ${ARGN})
    get_target_property(libraries ${target} LINK_LIBRARIES)
    foreach(library ${libraries})
        if(library MATCHES "^::@" OR library IN_LIST ARG_ALLOW)
            continue()
        endif()
        message(FATAL_ERROR "layer broken: ${target} links ${library}; allowed: ${ARG_ALLOW}")
    endforeach()
endfunction()
