// Walls that stop all of a light, against random rays.
#include "visibility/walls.h"

#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

using Triangle = std::array<glm::dvec3, 3>;

// Distance along the ray, in lengths of its direction; infinite if it misses.
double hit(const glm::dvec3& from, const glm::dvec3& direction, const Triangle& t) {
    // Cramer's rule for from + s * direction = t0 + u * (t1 - t0) + v * (t2 - t0).
    const glm::dmat3 system(-direction, t[1] - t[0], t[2] - t[0]);
    const double det = glm::determinant(system);
    if (det == 0.0) return std::numeric_limits<double>::infinity();
    const glm::dvec3 x = glm::inverse(system) * (from - t[0]);
    constexpr double tolerance = 1e-9;  // rays along a shared edge hit one of the two
    const bool inside = x.y >= -tolerance && x.z >= -tolerance && x.y + x.z <= 1.0 + tolerance && x.x > 0.0;
    return inside ? x.x : std::numeric_limits<double>::infinity();
}

// A rectangle around `centre`, in columns * rows * 2 triangles.
Blocker rectangle(const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v, int columns = 1, int rows = 1) {
    Blocker blocker;
    const auto corner = [&](int i, int j) {
        return centre + u * (2.0 * i / columns - 1.0) + v * (2.0 * j / rows - 1.0);
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            blocker.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            blocker.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
        }
    return blocker;
}

struct Room {
    Light light = projector();  // at the origin, looks along -Z
    View view = wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0}));
    std::vector<Blocker> blockers;
};

std::vector<glm::dvec4> wallsIn(const Room& room, std::uint32_t mapSize = 1024) {
    const BlockerSet blockers = BlockerSet::fromBlockers(room.blockers).value();
    WallScratch scratch;
    const LightPose pose = lightPose(room.light.worldFromLight, room.view.worldFromView);
    const auto walls = wallsOf(room.light, room.view, pose, blockers, mapSize, scratch);
    return {walls.begin(), walls.end()};
}

Room withWall(Blocker blocker) {
    Room room;
    room.blockers = {std::move(blocker)};
    return room;
}

const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);

TEST(Walls, AreWhatCoversTheWholePyramid) {
    EXPECT_EQ(wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * y))).size(), 1u);
    EXPECT_EQ(wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * y, 7, 5))).size(), 1u) << "of many triangles";
    EXPECT_EQ(wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * (y + z)))).size(), 1u) << "askance";
    EXPECT_TRUE(wallsIn(Room{}).empty());
    EXPECT_TRUE(wallsIn(withWall({})).empty()) << "no triangles";
    EXPECT_TRUE(wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 0.0 * y))).empty()) << "no area";
    EXPECT_TRUE(wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 0.4 * y))).empty()) << "too low";
}

TEST(Walls, LieAMarginBehindTheirTriangles) {
    const std::vector<glm::dvec4> walls = wallsIn(withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * y)));
    ASSERT_EQ(walls.size(), 1u);
    // In view space the eye stands 7 m before the wall, and so does the plane's positive side.
    EXPECT_NEAR(walls[0].z, 1.0, 1e-12);
    EXPECT_NEAR(walls[0].w, 7.0 + wallMargin(4.0), 1e-12);
}

TEST(Walls, NeedLampAndEyeBeforeThem) {
    EXPECT_TRUE(wallsIn(withWall(rectangle(1.0 * z, 3.0 * x, 3.0 * y))).empty()) << "behind the lamp";
    Room behind = withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * y));
    behind.view = wideView(lookingAt({0.0, 0.0, -9.0}, {0.0, 0.0, 0.0}));
    EXPECT_TRUE(wallsIn(behind).empty()) << "the eye is behind it";
    EXPECT_TRUE(wallsIn(withWall(rectangle(-0.3 * z, 3.0 * x, 3.0 * y))).empty()) << "before the near end";
    EXPECT_TRUE(wallsIn(withWall(rectangle(-0.5 * z, 3.0 * x, 3.0 * (y + z)))).empty()) << "through the near end";
    EXPECT_TRUE(wallsIn(withWall(rectangle(-7.0 * z, 3.0 * x, 3.0 * y))).empty()) << "beyond the far end";
}

// Rays begin on the near plane. If part of it lies behind a wall, the picture shows the air that the wall hides.
TEST(Walls, NeedTheWholePictureBeforeThem) {
    Room room = withWall(rectangle(-4.0 * z - 1.0 * y, 9.0 * x, 9.0 * z));  // a floor
    room.light.worldFromLight = lookingAt({0.0, 0.0, 0.0}, {0.0, -3.0, -3.0});
    const glm::dmat4 eye = lookingAt({0.0, -0.9, 3.0}, {0.0, -0.9, -3.0});  // 10 cm over it
    const auto walls = [&](const View& view) {
        room.view = view;
        return wallsIn(room).size();
    };
    EXPECT_EQ(walls(perspectiveView(eye, 1.0, 1.5, 0.1, 50.0)), 1u) << "down to 5 cm under the eye";
    EXPECT_EQ(walls(perspectiveView(eye, 1.0, 1.5, 0.2, 50.0)), 0u) << "11 cm";
    EXPECT_EQ(walls(orthographicView(eye, 1.0, 0.05, 0.1, 50.0)), 1u);
    EXPECT_EQ(walls(orthographicView(eye, 1.0, 2.0, 0.1, 50.0)), 0u);
}

TEST(Walls, FormCornersTogether) {
    // Two walls that meet in a vertical edge on the axis, and a floor before it.
    Room room;
    room.blockers = {rectangle(-3.0 * z - 2.0 * x, 2.0 * (x - z), 5.0 * y)};
    EXPECT_TRUE(wallsIn(room).empty()) << "one of them alone";
    room.blockers = {rectangle(-3.0 * z - 2.0 * x, 2.0 * (x - z), 5.0 * y),
                     rectangle(-3.0 * z + 2.0 * x, 2.0 * (x + z), 5.0 * y)};
    EXPECT_EQ(wallsIn(room).size(), 2u);
    room.blockers.push_back(rectangle(-3.0 * z - 0.5 * y, 6.0 * x, 6.0 * z));
    room.view = wideView(lookingAt({0.0, 1.0, 3.0}, {0.0, 0.0, -3.0}));
    EXPECT_EQ(wallsIn(room).size(), 3u) << "and the floor";
    room.blockers.push_back(rectangle(-2.0 * z, 0.2 * x, 0.2 * y));
    EXPECT_EQ(wallsIn(room).size(), 3u) << "something that stands free is no wall";
}

TEST(Walls, HaveNoHole) {
    // The face is the pyramid's section at 4 m, 3.4 m across; cracks of a millionth of that are allowed.
    Random random(1);
    for (const double side : {1.0, 0.3, 0.1, 0.01, 0.001, 0.0001}) {
        const double h = 0.5 * side;
        const glm::dvec2 at(between(random, -1.0, 1.0), between(random, -0.5, 0.5));
        const glm::dvec3 hole(at, -4.0);
        Room room;
        Blocker& wall = room.blockers.emplace_back();
        // Four rectangles around the hole.
        for (const Blocker& piece :
             {rectangle(hole - x * (2.0 + h), 2.0 * x, 4.0 * y), rectangle(hole + x * (2.0 + h), 2.0 * x, 4.0 * y),
              rectangle(hole - y * (2.0 + h), h * x, 2.0 * y), rectangle(hole + y * (2.0 + h), h * x, 2.0 * y)})
            wall.triangles.insert(wall.triangles.end(), piece.triangles.begin(), piece.triangles.end());
        EXPECT_TRUE(wallsIn(room).empty()) << side;
        const Blocker plug = rectangle(hole, h * x, h * y);
        wall.triangles.insert(wall.triangles.end(), plug.triangles.begin(), plug.triangles.end());
        EXPECT_EQ(wallsIn(room).size(), 1u) << side << " plugged";
    }
}

TEST(Walls, HaveNoRoundHoleEither) {
    // A hole of as many corners as there are triangles around it.
    for (const int corners : {12, 40, 100, 120})
        for (const double radius : {0.5, 0.02}) {
            Room room;
            Blocker& wall = room.blockers.emplace_back();
            const auto at = [&](int i, double r) {
                const double angle = 2.0 * glm::pi<double>() * i / corners;
                return glm::dvec3(r * std::cos(angle), r * std::sin(angle), -4.0);
            };
            for (int i = 0; i < corners; ++i) {
                wall.triangles.push_back({at(i, radius), at(i + 1, radius), at(i, 9.0)});
                wall.triangles.push_back({at(i + 1, radius), at(i, 9.0), at(i + 1, 9.0)});
            }
            EXPECT_TRUE(wallsIn(room).empty()) << corners << " corners, " << radius << " m";
        }
}

// Each triangle has a side on a tangent of the hole, and adds a corner to the remaining piece of the face.
TEST(Walls, HaveNoHoleOfMoreCornersThanAPieceHolds) {
    Room room;
    Blocker& wall = room.blockers.emplace_back();
    for (int i = 0; i < 60; ++i) {
        const double angle = 2.0 * glm::pi<double>() * i / 60.0;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0), along(-out.y, out.x, 0.0);
        const glm::dvec3 on = 0.5 * out - 4.0 * z;
        wall.triangles.push_back({on + 9.0 * along, on - 9.0 * along, on + 9.0 * out});
    }
    EXPECT_TRUE(wallsIn(room).empty());
}

// A map of 1024 texels over 40 by 24 degrees and a slanted wall: the difference between neighbouring texels, from the
// wall's equation.
TEST(Walls, KnowHowCoarselyAMapHoldsThem) {
    Room room = withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * (y + z)));  // z = -4 + y
    const std::vector<glm::dvec4> walls = wallsIn(room);
    ASSERT_EQ(walls.size(), 1u);
    const LightPose pose = lightPose(room.light.worldFromLight, room.view.worldFromView);
    const double texel = 2.0 * std::tan(12.0 * degrees) / 1024.0, slope = std::tan(12.0 * degrees);
    const auto axis = [](double s) { return 4.0 / (1.0 + s); };  // where the ray of slope s meets it
    const double farthest = axis(-slope), error = mapErrorAt(walls, room.light, pose, farthest, 1024);
    EXPECT_GE(error, axis(-slope) - axis(-slope + texel));
    EXPECT_LE(error, 1.01 * (axis(-slope) - axis(-slope + texel)));
    EXPECT_EQ(mapErrorAt({}, room.light, pose, farthest, 1024), 0.0);
    room = withWall(rectangle(-4.0 * z, 3.0 * x, 3.0 * y));
    EXPECT_NEAR(mapErrorAt(wallsIn(room), room.light, pose, 4.0, 1024), 0.0, 1e-12) << "head on, all texels agree";
}

// A floor 1.2 m below a lamp that shines along it: at the end of the beam one texel of the map covers metres of it, and
// a bias of metres would remove the shadows there.
TEST(Walls, AreNotSteepToTheLight) {
    Room room = withWall(rectangle(-1.2 * y - 12.0 * z, 40.0 * x, 30.0 * z));
    const Blocker back = rectangle(-20.0 * z, 40.0 * x, 40.0 * y);
    room.blockers.push_back(back);
    room.light.farPlane = 40.0;
    EXPECT_EQ(wallsIn(room, 64).size(), 1u) << "only the wall behind";
    EXPECT_EQ(wallsIn(room, 16384).size(), 2u) << "a map so fine knows the floor well";
    room.blockers = {rectangle(-4.0 * z, 9.0 * x, 9.0 * y)};
    EXPECT_EQ(wallsIn(room, 1).size(), 1u) << "head on, one texel will do";
}

// Random rectangles: every ray of the lamp is blocked before it gets behind a wall.
TEST(Walls, BlockEveryRay) {
    Random random(2);
    int found = 0, several = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Room room;
        const glm::dmat4 motion = rigidMotion(random, 100.0);
        room.light.worldFromLight = motion;
        room.view.worldFromView = motion * lookingAt(inCube(random, 0.4) + 0.3 * z, -3.0 * z);
        for (int i = 0, count = 1 + static_cast<int>(random() % 4); i < count; ++i) {
            const glm::dvec3 normal = glm::normalize(z + inCube(random, 1.0));
            const glm::dvec3 u = glm::normalize(glm::cross(y, normal)), v = glm::cross(normal, u);
            const glm::dvec3 centre(motion * glm::dvec4(-between(random, 1.5, 5.0) * z + inCube(random, 0.5), 1.0));
            const glm::dmat3 turn(motion);
            room.blockers.push_back(rectangle(centre, turn * u * between(random, 0.5, 6.0),
                                              turn * v * between(random, 0.5, 6.0), 1 + static_cast<int>(random() % 3),
                                              1 + static_cast<int>(random() % 3)));
            if (random() % 8 == 0) room.blockers.back().triangles.pop_back();
        }
        const std::vector<glm::dvec4> walls = wallsIn(room);
        found += !walls.empty();
        several += walls.size() > 1;
        if (walls.empty()) continue;
        const glm::dmat4 lightFromView = glm::inverse(room.light.worldFromLight) * room.view.worldFromView;
        std::vector<glm::dvec4> inLight;
        for (const glm::dvec4& wall : walls) inLight.push_back(wall * glm::inverse(lightFromView));
        const glm::dvec2 slope = glm::tan(0.5 * room.light.fov);
        for (int ray = 0; ray < 100; ++ray) {
            const glm::dvec3 direction(between(random, -slope.x, slope.x), between(random, -slope.y, slope.y), -1.0);
            double behind = room.light.farPlane;
            for (const glm::dvec4& wall : inLight) {
                const double approach = -glm::dot(glm::dvec3(wall), direction);
                if (approach > 0.0) behind = std::min(behind, wall.w / approach);
            }
            if (behind >= room.light.farPlane) continue;
            double blocked = std::numeric_limits<double>::infinity();
            for (const Blocker& blocker : room.blockers)
                for (const Triangle& t : blocker.triangles)
                    blocked = std::min(blocked, hit(glm::dvec3(motion[3]), glm::dmat3(motion) * direction, t));
            EXPECT_LE(blocked, behind) << trial;
            EXPECT_GE(behind, room.light.nearPlane) << trial;
        }
    }
    EXPECT_GT(found, 500);
    EXPECT_GT(several, 50);
}

}  // namespace
}  // namespace tyndall
