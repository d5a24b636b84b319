# The kernels are the same source compiled once per instruction set; each object exports one table, in a namespace of its
# own. Nothing but the table may be shared between them (tests/engine checks the symbols).
# -Wmaybe-uninitialized, and where all is inlined -Wuninitialized: GCC 12 warns of its own AVX-512 headers (its bug 105593).
# --param sra-...: without it GCC copies the blocks' structures as bytes. With it ashikhmin_shirley is 1.20 times as fast on AVX2,
# phong 1.40, ggx 1.18, and all about 1.03 on AVX-512; results are the same bits.
set(KERNEL_FLAGS -O3 -fno-math-errno -fno-trapping-math -ffp-contract=fast -Wno-maybe-uninitialized
                 --param=sra-max-scalarization-size-Ospeed=4096)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(KERNEL_FLAGS -ffp-contract=fast -Wno-maybe-uninitialized)
endif()
set(SANITIZED_ISA avx512)
set(SANITIZED_FLAGS)
if(GONIO_SANITIZE)
  # Fully inlined packets multiply what a sanitizer adds: minutes a file. Memory and races are checked through calls, without
  # debug information, and in the widest set only, which has the most lanes to overrun a buffer with: the source is the same
  # for all. Undefined behaviour of scalars is checked everywhere else.
  set(SANITIZED_FLAGS -O1 -g0 -fno-omit-frame-pointer -U__SANITIZE_THREAD__)
  if(GONIO_SANITIZE MATCHES "address")
    list(APPEND SANITIZED_FLAGS -fsanitize=address --param=asan-instrumentation-with-call-threshold=0 --param=asan-stack=0
                         -fno-sanitize-address-use-after-scope)
  elseif(GONIO_SANITIZE MATCHES "thread")
    list(APPEND SANITIZED_FLAGS -fsanitize=thread)
  endif()
endif()
set(FLAGS_baseline)
set(FLAGS_avx2 -mavx2 -mfma)
set(FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mavx2 -mfma -Wno-uninitialized)

# gonio_per_isa(TARGET ISA SOURCE...): the sources as an object library for one instruction set.
function(gonio_per_isa target isa)
  add_library(${target} OBJECT ${ARGN})
  target_compile_definitions(${target} PRIVATE GONIO_ISA=${isa} GONIO_ISA_${isa}=1)
  target_compile_options(${target} PRIVATE ${KERNEL_FLAGS} ${FLAGS_${isa}})
  set_target_properties(${target} PROPERTIES GONIO_OWN_SANITIZERS ON GONIO_IS_KERNEL ON)
  if(isa STREQUAL SANITIZED_ISA)
    target_compile_options(${target} PRIVATE ${SANITIZED_FLAGS})
  endif()
  target_link_libraries(${target} PRIVATE gonio_models gonio_options)
endfunction()

# gonio_models(TARGET LIST FOLDER): what each model of the list (models/list.h) is compiled as, a file of kernels per instruction
# set and one for the registry. FOLDER is where the models' headers are. The targets are TARGET_${isa} and TARGET.
function(gonio_models target list folder)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} lines REGEX "^GONIO_MODEL\\(")
  set(units)
  set(models)
  foreach(line ${lines})
    string(REGEX REPLACE "^GONIO_MODEL\\(([a-z0-9_]+), ([A-Za-z0-9]+)\\)$" "\\1;\\2" parts ${line})
    list(GET parts 0 name)
    list(GET parts 1 type)
    foreach(kind unit model)
      configure_file(${PROJECT_SOURCE_DIR}/src/kernels/${kind}.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${target}/${name}_${kind}.cpp @ONLY)
      list(APPEND ${kind}s ${CMAKE_CURRENT_BINARY_DIR}/${target}/${name}_${kind}.cpp)
    endforeach()
  endforeach()
  foreach(isa baseline avx2 avx512)
    gonio_per_isa(${target}_${isa} ${isa} ${units})
  endforeach()
  add_library(${target} OBJECT ${models})
  target_link_libraries(${target} PRIVATE gonio_models gonio_base gonio_options)
endfunction()
