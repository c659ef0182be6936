#error "a header of tyndall::plan includes Vulkan"
