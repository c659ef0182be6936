#include "check_outputs.h"

#include <kit/image/files.h>

namespace tyndall::app {

Result<void> checkOutputs(const std::string& scene, const std::string& picture,
                          const std::optional<std::string>& stats) {
    if (auto open = checkWritable(picture); !open) return open;
    if (sameFile(picture, scene)) return fail("-o: {} is the scene; name another file", picture);
    if (!stats) return {};
    if (auto open = checkWritable(*stats); !open) return open;
    if (sameFile(*stats, scene)) return fail("--stats: {} is the scene; name another file", *stats);
    if (sameFile(*stats, picture)) return fail("--stats: {} is the picture's file; name another one", *stats);
    return {};
}

}  // namespace tyndall::app
