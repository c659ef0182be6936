// One of several processes that report into one folder at a time: FOLDER NAME COUNT reports COUNT failures and removes
// the first.
#include <rig/report.h>

#include <cstdlib>

int main(int argc, char** argv) {
    using namespace tyndall;
    using namespace tyndall::rig;
    if (argc != 4) return 2;
    Image image = blankImage(8, 6, 4);
    for (float& value : image.values) value = 0.5f;
    for (int i = 0; i < std::atoi(argv[3]); ++i) {
        const Failure failure{{"slices", argv[2] + std::to_string(i), "p0", "golden"}, {}, "it is off", "run this"};
        if (!reportFailure(argv[1], failure, &image, &image)) return 1;
        if (i == 0 && !reportPass(argv[1], failure.subject)) return 1;
    }
    return 0;
}
