#include "room.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace tyndall::test {
namespace {

constexpr double degrees = 3.14159265358979323846 / 180.0;

glm::dmat4 posed(const glm::dvec3& position, double yaw, double pitch) {
    glm::dmat4 pose = glm::translate(glm::dmat4(1.0), position);
    pose = glm::rotate(pose, yaw * degrees, {0.0, 1.0, 0.0});
    return glm::rotate(pose, pitch * degrees, {1.0, 0.0, 0.0});
}

Texture slideOf(Slide slide) {
    return makeTexture(32, 32, 4, [&](int x, int y, int c) {
        switch (slide) {
            case Slide::Uniform:
                return 0.25 * (c + 1);
            case Slide::Checks:
                return (x / 4 + y / 4) % 2 ? 0.2 + 0.2 * c : 1.0;
            case Slide::Faint:
                return 0.5 + 0.001 * ((x / 4 + y / 4) % 2);
            case Slide::HalfDark:
                return x < 16 ? 0.0 : 0.75;
            default:
                return 0.0;
        }
    });
}

Texture dustOf(Dust dust) {
    return makeTexture(32, 32, 2, [&](int x, int y, int c) {
        if (dust == Dust::Uniform) return 0.6;
        if (dust == Dust::Faint) return 0.6 + 0.001 * ((x + y) % 2);
        return dust == Dust::Clean ? 0.0 : 0.5 + 0.5 * std::sin(0.7 * x + 1.3 * c) * std::cos(0.9 * y);
    });
}

Light lightOf(const LightRecipe& recipe) {
    Light light;
    light.worldFromLight = posed(0.1 * glm::dvec3(recipe.x, recipe.y, recipe.z), recipe.yaw, recipe.pitch);
    light.fov = degrees * glm::dvec2(recipe.width, recipe.height);
    light.nearPlane = 0.01 * recipe.near;
    light.farPlane = 6.0;
    light.colour = {1.0, 0.75, 0.5};
    light.intensity = std::exp2(recipe.strength);
    light.cookie = recipe.slide != Slide::None;
    light.shadow = recipe.shadow;
    if (recipe.dust != Dust::None) light.noise = Noise{};
    if (recipe.clipped) light.clipPlanes = {{0.0, 1.0, 0.0, -1.0}};
    return light;
}

void addQuad(std::vector<Triangle>& triangles, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    triangles.push_back({corner, corner + u, corner + u + v});
    triangles.push_back({corner, corner + u + v, corner + v});
}

// The input for a room's occluder and blocker sets.
struct Things {
    std::vector<OccluderBox> occluders;
    std::vector<Blocker> blockers;
};

void addBox(Room& room, Things& things, const BoxRecipe& recipe) {
    OccluderBox box;
    box.worldFromBox = posed(0.1 * glm::dvec3(recipe.x, recipe.y, recipe.z), recipe.yaw, 0.0);
    box.maximum = 0.05 * glm::dvec3(recipe.width, recipe.height, recipe.depth);
    box.minimum = -box.maximum;
    things.occluders.push_back(box);
    const glm::dmat3 axes(box.worldFromBox);
    const glm::dvec3 size = box.maximum - box.minimum;
    const glm::dvec3 low(box.worldFromBox * glm::dvec4(box.minimum, 1.0));
    const glm::dvec3 high(box.worldFromBox * glm::dvec4(box.maximum, 1.0));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 u = axes[i] * size[i], v = axes[(i + 1) % 3] * size[(i + 1) % 3];
        addQuad(room.triangles, low, u, v);
        addQuad(room.triangles, high, -u, -v);
    }
}

// A flat surface that is both an occluder and a blocker.
void addSurface(Room& room, Things& things, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    addQuad(room.triangles, corner, u, v);
    Blocker blocker;
    addQuad(blocker.triangles, corner, u, v);
    things.blockers.push_back(blocker);
    OccluderBox box;
    box.minimum = glm::min(corner, corner + u + v);
    box.maximum = glm::max(corner, corner + u + v);
    things.occluders.push_back(box);
}

// Distance from `from`, in lengths of `direction`.
double hit(const glm::dvec3& from, const glm::dvec3& direction, const Triangle& t) {
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], p = glm::cross(direction, v);
    const double det = glm::dot(u, p);
    if (det == 0.0) return std::numeric_limits<double>::infinity();
    const glm::dvec3 s = from - t[0], q = glm::cross(s, u);
    const double a = glm::dot(s, p) / det, b = glm::dot(direction, q) / det, at = glm::dot(v, q) / det;
    constexpr double eps = 1e-12;
    return a >= -eps && b >= -eps && a + b <= 1.0 + eps ? at : std::numeric_limits<double>::infinity();
}

// View depth of the nearest surface at each pixel's centre, and the farthest of each tile.
void castDepths(Room& room) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const View& view = room.view;
    const glm::dmat4 rows = glm::transpose(view.clipFromView);
    const glm::dvec3 eye(view.worldFromView[3]);
    room.tiles.assign(static_cast<std::size_t>(room.columns) * room.rows, 0.0f);
    room.depth = makeTexture(Room::width, Room::height, 1, [&](int x, int y, int) {
        const glm::dvec2 ndc(2.0 * (x + 0.5) / Room::width - 1.0, 2.0 * (y + 0.5) / Room::height - 1.0);
        // No projection of these tests is shifted.
        const glm::dvec2 across = ndc / glm::dvec2(rows[0].x, rows[1].y);
        const glm::dvec3 origin = view.orthographic ? glm::dvec3(across, 0.0) : glm::dvec3(0.0);
        const glm::dvec3 direction = view.orthographic ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(across, -1.0);
        const glm::dmat3 turn(view.worldFromView);
        double depth = infinity;
        for (const Triangle& triangle : room.triangles) {
            const double at = hit(eye + turn * origin, turn * direction, triangle);
            if (at >= view.nearPlane) depth = std::min(depth, at);
        }
        if (depth > view.farPlane) depth = infinity;
        // All tiles that the pixel overlaps.
        const auto tiles = [](int i, int side, int count) {
            return std::pair(i * count / side, ((i + 1) * count - 1) / side);
        };
        const auto [left, right] = tiles(x, Room::width, room.columns);
        const auto [top, bottom] = tiles(y, Room::height, room.rows);
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                float& farthest = room.tiles[static_cast<std::size_t>(row) * room.columns + column];
                farthest = std::max(farthest, static_cast<float>(depth));
            }
        if (depth == infinity) return 0.0;
        const glm::dvec4 clip = view.clipFromView * glm::dvec4(origin + depth * direction, 1.0);
        return clip.z / clip.w;
    });
}

std::vector<glm::vec4> texelsOf(const Texture& texture) {
    std::vector<glm::vec4> texels;
    for (int y = 0; y < texture.height; ++y)
        for (int x = 0; x < texture.width; ++x) {
            glm::vec4 texel(0.0f);
            for (int c = 0; c < texture.channels; ++c) texel[c] = texture.at(x, y, c);
            texels.push_back(texel);
        }
    return texels;
}

}  // namespace

Surroundings Room::surroundings() const {
    Surroundings all;
    all.occluders = &occluders;
    all.blockers = &blockers;
    all.depth = DepthTiles{static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), tiles};
    all.surveys = lightSurveys;
    return all;
}

void build(const Recipe& recipe, Room& room) {
    for (const LightRecipe& light : recipe.lights) {
        room.lights.push_back(lightOf(light));
        room.slides.push_back(light.slide == Slide::None ? Texture{} : slideOf(light.slide));
        room.dust.push_back(light.dust == Dust::None ? Texture{} : dustOf(light.dust));
    }
    Things things;
    for (const BoxRecipe& box : recipe.boxes) addBox(room, things, box);
    if (recipe.floor) addSurface(room, things, {-4.0, 0.0, -4.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 8.0});
    if (recipe.wall) addSurface(room, things, {-4.0, 0.0, -4.0}, {8.0, 0.0, 0.0}, {0.0, 4.0, 0.0});

    room.occluders = OccluderSet::fromBoxes(things.occluders).value();
    room.blockers = BlockerSet::fromBlockers(std::move(things.blockers)).value();

    const glm::dvec3 eye = 0.1 * glm::dvec3(recipe.eyeX, recipe.eyeY, recipe.eyeZ);
    const double towards = std::atan2(eye.x, eye.z + 1e-9) / degrees;  // -Z at 0
    const glm::dmat4 worldFromView = posed(eye, towards + recipe.yaw, recipe.pitch);
    constexpr double aspect = static_cast<double>(Room::width) / Room::height;
    room.view = recipe.orthographic ? orthographicView(worldFromView, 2.0 * aspect, 2.0, 0.1, 50.0)
                                    : perspectiveView(worldFromView, recipe.fov * degrees, aspect, 0.1, 50.0);
    room.columns = recipe.columns;
    room.rows = recipe.rows;
    castDepths(room);

    room.surveys.resize(2 * room.lights.size());
    for (std::size_t i = 0; i < room.lights.size(); ++i) {
        LightSurvey& survey = room.lightSurveys.emplace_back();
        const auto made = [&](const Texture& texture, bool wraps, TextureSurvey& into) -> const TextureSurvey* {
            if (texture.texels.empty()) return nullptr;
            into = surveyTexture(texture.width, texture.height, texelsOf(texture), wraps);
            return &into;
        };
        survey.cookie = made(room.slides[i], false, room.surveys[2 * i]);
        survey.noise = made(room.dust[i], true, room.surveys[2 * i + 1]);
    }

    room.options.slices = recipe.slices;
    room.options.spacing = recipe.adaptive ? Spacing::Adaptive : Spacing::Even;
    room.options.geometry = recipe.quads ? Geometry::StretchedQuads : Geometry::ExactPolygons;
    room.options.accumulation = Accumulation::Rgba32f;
    room.options.time = 3.25;
    room.options.shadowMapSize = Room::shadowMapSize;
    room.options.pictureHeight = Room::height;
    room.options.displayStep = 1.0 / 256.0;
}

}  // namespace tyndall::test
