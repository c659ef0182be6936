// Breaks every documented bound and expects one sentence with the place, the field and a remedy.
#include <gtest/gtest.h>

#include <functional>

#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

struct Given {
    Light light = projector();
    View view = perspectiveView(lookingAt({0, 0, 5}, {0, 0, 0}), 1.0, 1.5, 0.1, 100.0);
    PlanOptions options;
};

struct BrokenCase {
    const char* names;  // place and field, as the message has them
    std::function<void(Given&)> change;
};

void expectBroken(const BrokenCase& c) {
    Given given;
    given.light.name = "lamp";
    c.change(given);
    const std::vector<Light> lights = {projector(), given.light};
    const Result<Plan> result = plan(lights, given.view, given.options);
    ASSERT_FALSE(result.has_value()) << c.names;
    EXPECT_EQ(result.error().code, ErrorCode::InvalidArgument);
    const std::string& message = result.error().message;
    EXPECT_EQ(message.rfind(c.names, 0), 0u) << "expected " << c.names << " in: " << message;
    EXPECT_NE(result.error().place, "");
    EXPECT_EQ(message.rfind(result.error().place + ": ", 0), 0u) << result.error().place << " in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find("must"), std::string::npos) << "names no rule: " << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "names no remedy: " << message;
}

// A field, with its place, that gets each non-finite value.
std::vector<BrokenCase> notFinite(const char* names, const std::function<double&(Given&)>& field) {
    std::vector<BrokenCase> cases;
    for (const double value : {nan, infinity, -infinity}) cases.push_back({names, [=](Given& g) { field(g) = value; }});
    return cases;
}

TEST(Bounds, TheUnbrokenCaseIsPlanned) {
    Given given;
    const Result<Plan> result = plan({&given.light, 1}, given.view, given.options);
    ASSERT_TRUE(result.has_value()) << result.error().message;
    EXPECT_TRUE(result->lights[0].drawn) << reason(result->lights[0], given.view);
}

TEST(Bounds, OfALight) {
    const BrokenCase cases[] = {
        {"light 1 \"lamp\": fov.x is 0:", [](Given& g) { g.light.fov.x = 0.0; }},
        {"light 1 \"lamp\": fov.y is -0.5:", [](Given& g) { g.light.fov.y = -0.5; }},
        {"light 1 \"lamp\": fov.x is 1e-09:", [](Given& g) { g.light.fov.x = 1e-9; }},
        {"light 1 \"lamp\": fov.x is 3.14159265:", [](Given& g) { g.light.fov.x = glm::pi<double>(); }},
        {"light 1 \"lamp\": fov.y is 3.13", [](Given& g) { g.light.fov.y = 179.5 * degrees; }},
        {"light 1 \"lamp\": nearPlane is 0:", [](Given& g) { g.light.nearPlane = 0.0; }},
        {"light 1 \"lamp\": nearPlane is -1:", [](Given& g) { g.light.nearPlane = -1.0; }},
        {"light 1 \"lamp\": farPlane is 0.5: it must be beyond", [](Given& g) { g.light.farPlane = 0.5; }},
        {"light 1 \"lamp\": farPlane is 0.4: it must be beyond", [](Given& g) { g.light.farPlane = 0.4; }},
        {"light 1 \"lamp\": farPlane is 1e+12:", [](Given& g) { g.light.farPlane = 1e12; }},
        {"light 1 \"lamp\": colour.g is -0.1:", [](Given& g) { g.light.colour.g = -0.1; }},
        {"light 1 \"lamp\": intensity is -1:", [](Given& g) { g.light.intensity = -1.0; }},
        {"light 1 \"lamp\": density is -1:", [](Given& g) { g.light.density = -1.0; }},
        {"light 1 \"lamp\": ambient is -1:", [](Given& g) { g.light.ambient = -1.0; }},
        {"light 1 \"lamp\": its strength", [](Given& g) { g.light.intensity = 1e39; }},
        {"light 1 \"lamp\": its strength", [](Given& g) { g.light.colour = glm::dvec3(g.light.density = 1e30); }},
        {"light 1 \"lamp\": its strength",
         [](Given& g) {
             g.light.noise = Noise{};
             g.light.noise->scroll1.x = g.options.time = 1e200;
         }},
        {"light 1 \"lamp\": noise.gain is -1:",
         [](Given& g) {
             g.light.noise = Noise{};
             g.light.noise->gain = -1.0;
         }},
        {"light 1 \"lamp\": clipPlanes has 7 planes:",
         [](Given& g) {
             g.light.clipPlanes.resize(7, {0, 1, 0, 9});
         }},
        {"light 1 \"lamp\": clipPlanes has 3 planes:",
         [](Given& g) {
             g.options.geometry = Geometry::StretchedQuads;
             g.light.clipPlanes.resize(3, {0, 1, 0, 9});
         }},
        {"light 1 \"lamp\": clipPlanes[1] is (0, 0, 0, 1), whose normal",
         [](Given& g) {
             g.light.clipPlanes = {{0, 1, 0, 9}, {0, 0, 0, 1}};
         }},
        {"light 1 \"lamp\": clipPlanes[0] is",
         [](Given& g) {
             g.light.clipPlanes = {{0, 1, 0, infinity}};
         }},
        {"light 1 \"lamp\": clipPlanes[0] is",
         [](Given& g) {
             g.light.clipPlanes = {{0, nan, 0, 1}};
         }},
        {"light 1 \"lamp\": clipPlanes[0] is",
         [](Given& g) {
             g.light.clipPlanes = {{0, 1e200, 0, 1}};
         }},
    };
    for (const BrokenCase& c : cases) expectBroken(c);
}

TEST(Bounds, OfPoses) {
    for (const std::string which : {"light 1 \"lamp\": worldFromLight", "view: worldFromView"}) {
        const auto pose = [&](Given& g) -> glm::dmat4& {
            return which[0] == 'l' ? g.light.worldFromLight : g.view.worldFromView;
        };
        const std::pair<std::string, std::function<void(glm::dmat4&)>> cases[] = {
            {" is not rigid", [](glm::dmat4& m) { m[0] *= 1.0 + 1e-5; }},
            {" is not rigid", [](glm::dmat4& m) { m[0] = m[1]; }},
            {" is not rigid", [](glm::dmat4& m) { m[0] *= 0.0; }},
            {" is not rigid", [](glm::dmat4& m) { m[1].x += 1e-5; }},
            {" is not rigid", [](glm::dmat4& m) { m[0] *= 1e200; }},
            {" mirrors", [](glm::dmat4& m) { m[0] = -m[0]; }},
            {" has the last row", [](glm::dmat4& m) { m[3].w = 2.0; }},
            {" has the last row", [](glm::dmat4& m) { m[0].w = 0.1; }},
            {" has the position 1e+10", [](glm::dmat4& m) { m[3].y = 1e10; }},
            {" has nan in row 2, column 1", [](glm::dmat4& m) { m[1][2] = nan; }},
            {" has inf in row 0, column 3", [](glm::dmat4& m) { m[3][0] = infinity; }},
        };
        for (const auto& [says, change] : cases)
            expectBroken({(which + says).c_str(), [&](Given& g) { change(pose(g)); }});
        Given given;
        pose(given)[0] *= 1.0 + 2e-7;  // a float's rounding is no error
        EXPECT_TRUE(plan({&given.light, 1}, given.view, given.options).has_value());
    }
}

TEST(Bounds, OfTheView) {
    const auto eye = lookingAt({0, 0, 5}, {0, 0, 0});
    const BrokenCase cases[] = {
        {"view: nearPlane is 0:", [](Given& g) { g.view.nearPlane = 0.0; }},
        {"view: nearPlane is -1:", [](Given& g) { g.view.nearPlane = -1.0; }},
        {"view: nearPlane is nan:", [](Given& g) { g.view.nearPlane = nan; }},
        {"view: farPlane is 0.1: it must be beyond", [](Given& g) { g.view.farPlane = 0.1; }},
        {"view: farPlane is -inf:", [](Given& g) { g.view.farPlane = -infinity; }},
        {"view: farPlane is nan:", [](Given& g) { g.view.farPlane = nan; }},
        {"view: sceneDepth is inf:", [](Given& g) { g.view.sceneDepth = infinity; }},
        {"view: sceneDepth is nan:", [](Given& g) { g.view.sceneDepth = nan; }},
        {"view: sceneDepth is 0:", [](Given& g) { g.view.sceneDepth = 0.0; }},
        {"view: clipFromView has nan", [=](Given& g) { g.view = perspectiveView(eye, 0.0, 1.0, 0.1, 10.0); }},
        {"view: clipFromView has nan", [=](Given& g) { g.view = perspectiveView(eye, 3.15, 1.0, 0.1, 10.0); }},
        {"view: clipFromView has nan", [=](Given& g) { g.view = perspectiveView(eye, 1.0, -1.0, 0.1, 10.0); }},
        {"view: clipFromView scales x", [=](Given& g) { g.view = perspectiveView(eye, 3.141592, 1.0, 0.1, 10.0); }},
        {"view: clipFromView has nan", [=](Given& g) { g.view = orthographicView(eye, 0.0, 1.0, 0.1, 10.0); }},
        {"view: farPlane is inf", [=](Given& g) { g.view = orthographicView(eye, 1.0, 1.0, 0.1, infinity); }},
        {"view: clipFromView has inf", [](Given& g) { g.view.clipFromView[0][0] = infinity; }},
        {"view: clipFromView has the last row", [](Given& g) { g.view.orthographic = true; }},
        {"view: clipFromView has the last row",
         [=](Given& g) {
             g.view = orthographicView(eye, 1.0, 1.0, 0.1, 10.0);
             g.view.orthographic = false;
         }},
        {"view: clipFromView has the last row", [](Given& g) { g.view.clipFromView[2][3] = 1.0; }},
        {"view: clipFromView scales y", [](Given& g) { g.view.clipFromView[1][1] = 0.0; }},
        {"view: clipFromView is singular", [](Given& g) { g.view.clipFromView[3][2] = 0.0; }},
    };
    for (const BrokenCase& c : cases) expectBroken(c);
}

TEST(Bounds, OfTheOptions) {
    const BrokenCase cases[] = {
        {"plan options: slices is 0:", [](Given& g) { g.options.slices = 0; }},
        {"plan options: slices is -4:", [](Given& g) { g.options.slices = -4; }},
        {"plan options: slices is 65537:", [](Given& g) { g.options.slices = 65537; }},
        {"plan options: slices is 6: it must be a multiple of 4",
         [](Given& g) {
             g.options.slices = 6;
             g.options.accumulation = Accumulation::Rgba8Routed;
         }},
        {"plan options: range is 0:", [](Given& g) { g.options.range = 0.0; }},
        {"plan options: range is -1:", [](Given& g) { g.options.range = -1.0; }},
        {"plan options: shadowMapSize is 0:", [](Given& g) { g.options.shadowMapSize = 0; }},
        {"plan options: shadowBias is -0.1:", [](Given& g) { g.options.shadowBias = -0.1; }},
    };
    for (const BrokenCase& c : cases) expectBroken(c);
}

TEST(Bounds, TakeNoValueThatIsNotFinite) {
    const std::pair<const char*, std::function<double&(Given&)>> fields[] = {
        {"light 1 \"lamp\": fov.x", [](Given& g) -> double& { return g.light.fov.x; }},
        {"light 1 \"lamp\": fov.y", [](Given& g) -> double& { return g.light.fov.y; }},
        {"light 1 \"lamp\": nearPlane", [](Given& g) -> double& { return g.light.nearPlane; }},
        {"light 1 \"lamp\": farPlane", [](Given& g) -> double& { return g.light.farPlane; }},
        {"light 1 \"lamp\": colour.r", [](Given& g) -> double& { return g.light.colour.r; }},
        {"light 1 \"lamp\": colour.g", [](Given& g) -> double& { return g.light.colour.g; }},
        {"light 1 \"lamp\": colour.b", [](Given& g) -> double& { return g.light.colour.b; }},
        {"light 1 \"lamp\": intensity", [](Given& g) -> double& { return g.light.intensity; }},
        {"light 1 \"lamp\": density", [](Given& g) -> double& { return g.light.density; }},
        {"light 1 \"lamp\": ambient", [](Given& g) -> double& { return g.light.ambient; }},
        {"light 1 \"lamp\": noise.scale.x", [](Given& g) -> double& { return g.light.noise.emplace().scale.x; }},
        {"light 1 \"lamp\": noise.scale.y", [](Given& g) -> double& { return g.light.noise.emplace().scale.y; }},
        {"light 1 \"lamp\": noise.scroll1.x", [](Given& g) -> double& { return g.light.noise.emplace().scroll1.x; }},
        {"light 1 \"lamp\": noise.scroll1.y", [](Given& g) -> double& { return g.light.noise.emplace().scroll1.y; }},
        {"light 1 \"lamp\": noise.scroll2.x", [](Given& g) -> double& { return g.light.noise.emplace().scroll2.x; }},
        {"light 1 \"lamp\": noise.scroll2.y", [](Given& g) -> double& { return g.light.noise.emplace().scroll2.y; }},
        {"light 1 \"lamp\": noise.gain", [](Given& g) -> double& { return g.light.noise.emplace().gain; }},
        {"plan options: time", [](Given& g) -> double& { return g.options.time; }},
        {"plan options: range", [](Given& g) -> double& { return g.options.range; }},
        {"plan options: shadowBias", [](Given& g) -> double& { return g.options.shadowBias; }},
    };
    for (const auto& [names, field] : fields)
        for (const BrokenCase& c : notFinite(names, field)) expectBroken(c);
}

TEST(Bounds, HoldForLightsThatWouldNotBeDrawn) {
    expectBroken({"light 1 \"lamp\": farPlane", [](Given& g) {
                      g.light.colour = glm::dvec3(0.0);
                      g.light.farPlane = nan;
                  }});
}

TEST(Bounds, OfAllSlicesTogether) {
    std::vector<Light> lights(300, projector());
    Given given;
    given.options.slices = 65536;
    const Result<Plan> result = plan(lights, given.view, given.options);
    ASSERT_FALSE(result.has_value());
    EXPECT_NE(result.error().message.find("300 lights"), std::string::npos) << result.error().message;
}

TEST(Bounds, LightsWithoutANameGoByNumber) {
    std::vector<Light> lights(3, projector());
    lights[2].nearPlane = 0.0;
    Given given;
    EXPECT_EQ(plan(lights, given.view, given.options).error().message.rfind("light 2: nearPlane", 0), 0u);
}

}  // namespace
}  // namespace tyndall
