# POSECOACH_SANITIZE: empty, "address,undefined" or "thread".
set(POSECOACH_SANITIZE "" CACHE STRING "Sanitizers for every target")
if(POSECOACH_SANITIZE)
  add_compile_options(-fsanitize=${POSECOACH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${POSECOACH_SANITIZE})
endif()
