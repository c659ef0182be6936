#include <kit/image/write_picture.h>

#include <cmath>

#include "add_options.h"

namespace tyndall::app {

constexpr unsigned maxThreads = 1024;

void addReference(CLI::App& app, ReferenceOptions& options, std::string& size) {
    addViewOptions(app, options.view, size);
    app.add_option("-o,--output", options.output, "picture to write, .exr of 32-bit floats (they round to 6e-8)")
        ->required()
        ->type_name("IMAGE.exr");
    addChoice(app, "--mode", options.mode, modeWords,
              "shadows and surfaces from the triangles, or from the renderer's shadow maps and depth");
    addTechnique(app, options.terms, "leave out of every light what this technique of slices.fx leaves out");
    app.add_option("--accuracy", options.accuracy, "relative error of each pixel, 1e-12 to 1; 1e-8")->type_name("E");
    app.add_option("--threads", options.threads, "0: one for each processor")->type_name("N");
    addShadowSize(app, options.shadowSize);
    addOptional(app, "--stats", options.stats, "FILE.json", "time, memory, and the accuracy reached");
}

Result<void> checkReference(const ReferenceOptions& options, bool shadowSizeGiven) {
    if (options.output.empty()) return fail("-o: the picture's name is empty; give one");
    if (pictureFormat(options.output) != PictureFormat::Exr)
        return fail("-o: {} cannot hold radiance without limits; write an .exr", options.output);
    if (!(options.accuracy >= 1e-12 && options.accuracy <= 1.0))
        return fail("--accuracy: {} is out of bounds; take from 1e-12 to 1", options.accuracy);
    if (options.threads > maxThreads)
        return fail("--threads: {} is out of bounds; take from 0 to {}", options.threads, maxThreads);
    if (shadowSizeGiven && options.mode == study::Mode::Ideal)
        return fail("--shadow-size: the ideal mode has no shadow maps; leave it out, or add --mode hardware");
    return checkShadowSize(options.shadowSize);
}

}  // namespace tyndall::app
