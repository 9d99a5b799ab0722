# cmake -D ROOT=DIR -P check_includes.cmake: fails when a folder includes what its layer may not.
# Lists say what is allowed: what nobody thought of is forbidden.

# Every line of a folder's files that includes what `wanted` matches must include what `allowed`
# matches.
function(check folder wanted allowed)
    file(GLOB_RECURSE sources ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
    foreach(source ${sources})
        file(STRINGS ${source} hits REGEX "^[ \t]*#[ \t]*include[ \t]*${wanted}")
        foreach(hit ${hits})
            if(NOT hit MATCHES "include[ \t]*${allowed}")
                message(SEND_ERROR "layer broken: ${source}: ${hit}")
            endif()
        endforeach()
    endforeach()
endfunction()

# Files of this repository that a folder may include.
function(allow folder pattern)
    check(${folder} "\"" "\"(${pattern})")
endfunction()
# Files of packages that a folder may include; the standard library's have no dot and no slash.
function(allow_packages folder pattern)
    check(${folder} "<[^>]*[./]" "<(${pattern})")
endfunction()

set(system "(fcntl|poll|pthread|sched|signal|unistd|dirent|link)\\.h|[ei]mmintrin\\.h|sys/|zlib\\.h")
allow(common "common/")
allow(formats "common/|formats/")
allow(runtime "common/|formats/|runtime/")
allow(shapegen "common/|formats/|shapegen/")
allow_packages(common "Eigen/|${system}|xxhash\\.h")
allow_packages(formats "${system}|flatbuffers/|particle_template_generated\\.h")
allow_packages(runtime "Eigen/|${system}|hdf5\\.h|H5|nlohmann/|boost/program_options")
allow_packages(shapegen "Eigen/|${system}|nlohmann/|boost/|CGAL/|assimp/|glpk\\.h")

# The contact kernels know no particle arrays, threads or files; their rooms have an order.
set(contact "common/(math|shapes)/|common/error|runtime/contact/contact_types")
allow(runtime/contact/law "${contact}|runtime/contact/law/")
allow(runtime/contact/walls "${contact}|runtime/contact/walls/")
allow(runtime/contact/smooth "${contact}|runtime/contact/(law|walls|smooth)/")
allow(runtime/contact/fields "${contact}|runtime/contact/(law|walls|fields)/")
allow(runtime/contact/cores "${contact}|runtime/contact/(law|smooth|cores)/")
allow(runtime/contact/meshes "${contact}|runtime/contact/(law|walls|smooth|fields|meshes)/")
allow(runtime/contact/pairs "${contact}|runtime/contact/(law|walls|smooth|fields|cores|meshes|pairs)/")
allow(runtime/contact/lanes "${contact}|runtime/contact/(law|walls|smooth|pairs|lanes)/")
# memory: walls share their triangles.
check(runtime/contact "<" "<(algorithm|array|bit|cmath|concepts|cstddef|cstdint|limits|memory|numbers|optional|span|sstream|string|string_view|tuple|type_traits|utility|variant|vector)>")
