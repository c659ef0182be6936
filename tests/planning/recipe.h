// A random scene as a few whole numbers, so that a property-based test can shrink and print it.
#pragma once

#include <iosfwd>
#include <vector>

namespace tyndall::test {

enum class Slide { None, Uniform, Checks, HalfDark, Black, Faint };
enum class Dust { None, Uniform, Grains, Clean, Faint };

struct LightRecipe {
    int x = 0, y = 20, z = 0;     ///< decimetres
    int yaw = 0, pitch = -40;     ///< degrees
    int width = 40, height = 30;  ///< degrees
    int near = 20;                ///< centimetres
    int strength = 8;             ///< powers of 2, candela
    Slide slide = Slide::None;
    Dust dust = Dust::None;
    bool shadow = false;
    bool clipped = false;  ///< by a plane 1 m over the floor
};

struct BoxRecipe {
    int x = 0, y = 10, z = 0;              ///< decimetres
    int width = 5, height = 5, depth = 5;  ///< decimetres
    int yaw = 0;                           ///< degrees
};

/// A room of 8 x 8 m, 4 m high; floor and back wall are optional.
struct Recipe {
    std::vector<LightRecipe> lights;
    std::vector<BoxRecipe> boxes;
    bool floor = false, wall = false;
    int eyeX = 0, eyeY = 15, eyeZ = 35;  ///< decimetres
    int yaw = 0, pitch = 0;              ///< degrees, from the direction of the room's middle
    int fov = 60;                        ///< degrees, vertical
    bool orthographic = false;
    bool adaptive = false, quads = false;
    int slices = 64;
    int columns = 8, rows = 6;  ///< of depth tiles
};

std::ostream& operator<<(std::ostream& out, const Recipe& recipe);

}  // namespace tyndall::test
