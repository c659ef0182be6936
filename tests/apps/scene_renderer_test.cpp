// The cost of a scene's second frame, and its equality with the picture of a new renderer.
#include <gtest/gtest.h>
#include <headless/device.h>
#include <tyndall/frame/plan_scene.h>
#include <tyndall/frame/scene_renderer.h>
#include <tyndall/frame/scene_view.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "must.h"

namespace tyndall::test {
namespace {

using namespace tyndall::app;

/// The theatre: many lights, shared cookies, noise, textures on surfaces.
class SceneRendererTest : public testing::Test {
protected:
    void SetUp() override {
        view.scene = TYNDALL_SCENES "/stage.glb";
        view.size = {64, 36};
        shafts.plan.shadowMapSize = 64;
        shafts.exposure = 0.0;
        auto made = headless::Device::create({.validation = true});
        ASSERT_TRUE(made) << made.error().message;
        device.emplace(std::move(*made));
        planned.emplace(must(prepareScene(view)));
    }

    void TearDown() override {
        if (!device) return;
        EXPECT_TRUE(device->messages().empty()) << device->messages().front();
    }

    SceneRenderer renderer() { return must(SceneRenderer::create(*device, planned->scene)); }
    Frame draw(SceneRenderer& renderer) { return must(renderer.draw(*planned, view, shafts, false)); }

    /// Drawn by a new renderer, with the scene's facts computed again.
    void expectAsFresh(const Frame& frame) {
        PlannedScene anew = must(prepareScene(view));
        anew.scene.instances = planned->scene.instances;
        anew.facts = must(surveyScene(anew.scene));
        anew.lights = planned->lights;
        anew.view = planned->view;
        SceneRenderer fresh = must(SceneRenderer::create(*device, anew.scene));
        EXPECT_TRUE(must(fresh.draw(anew, view, shafts, false)).picture.values == frame.picture.values)
            << "bit for bit";
        const auto fromAnew = anew.facts.blockers.blockers(), followed = planned->facts.blockers.blockers();
        ASSERT_EQ(fromAnew.size(), followed.size());
        for (std::size_t i = 0; i < fromAnew.size(); ++i) EXPECT_EQ(fromAnew[i].triangles, followed[i].triangles);
    }

    /// Far behind the theatre, looking away from it.
    void turnAway() {
        planned->view.worldFromView = glm::translate(planned->view.worldFromView, {0.0, 0.0, 1000.0});
        planned->view.worldFromView = glm::rotate(planned->view.worldFromView, 3.1, {0.0, 1.0, 0.0});
    }

    std::size_t mapsCalledFor() const {
        return static_cast<std::size_t>(std::ranges::count_if(planned->surfaceLights, &SurfaceLight::shadow));
    }

    std::optional<headless::Device> device;
    ViewOptions view;
    ShaftOptions shafts;
    std::optional<PlannedScene> planned;
};

void expectNothingNew(const FrameStatistics& frame) {
    EXPECT_EQ(frame.imagesUploaded, 0u);
    EXPECT_EQ(frame.imageBytes, 0u);
    EXPECT_EQ(frame.shafts.shadowMapsDrawn, 0u);
    EXPECT_EQ(frame.shadowMaps, 0.0);
    EXPECT_EQ(frame.shafts.pipelinesCreated, 0u);
    EXPECT_EQ(frame.surfacePipelines, 0u);
    EXPECT_EQ(frame.shafts.neutralTexturesCreated, 0u);
}

TEST_F(SceneRendererTest, AnUnchangedSceneIsDrawnAgainFromWhatIsThere) {
    SceneRenderer kept = renderer();
    const Frame first = draw(kept);
    EXPECT_GT(first.statistics.imagesUploaded, 0u);
    EXPECT_GT(first.statistics.shafts.pipelinesCreated, 0u);
    EXPECT_GT(first.statistics.surfacePipelines, 0u);
    EXPECT_EQ(first.statistics.shafts.shadowMapsDrawn, mapsCalledFor());
    const std::uint64_t held = device->memoryAllocated();
    const Frame second = draw(kept);
    expectNothingNew(second.statistics);
    EXPECT_EQ(device->memoryAllocated(), held);
    EXPECT_EQ(second.statistics.shafts.draws, first.statistics.shafts.draws) << "each frame's own";
    EXPECT_EQ(second.statistics.shafts.slicesDrawn, first.statistics.shafts.slicesDrawn);
    EXPECT_EQ(second.statistics.shafts.bytesUploaded, first.statistics.shafts.bytesUploaded);
    EXPECT_EQ(second.statistics.surfaceDraws, first.statistics.surfaceDraws);
    EXPECT_TRUE(second.picture.values == first.picture.values) << "bit for bit";
    planned->view.sceneDepth = 0.5;  // as a frame close to a wall leaves it
    EXPECT_TRUE(draw(kept).picture.values == first.picture.values) << "bit for bit";
}

TEST_F(SceneRendererTest, WhatIsOutOfViewCostsNothingAndIsThereWhenTheEyeComesBack) {
    const glm::dmat4 seat = planned->view.worldFromView;
    SceneRenderer kept = renderer();
    const Frame first = draw(kept);
    turnAway();
    const Frame away = draw(kept);
    ASSERT_EQ(mapsCalledFor(), 0u) << "else this tests nothing";
    EXPECT_EQ(away.statistics.shafts.draws, 0u);
    EXPECT_EQ(away.statistics.shafts.bytesUploaded, 0u);
    expectNothingNew(away.statistics);
    expectAsFresh(away);
    const std::uint64_t held = device->memoryAllocated();
    planned->view.worldFromView = seat;
    const Frame back = draw(kept);
    expectNothingNew(back.statistics);
    EXPECT_EQ(device->memoryAllocated(), held);
    EXPECT_TRUE(back.picture.values == first.picture.values) << "bit for bit";
}

TEST_F(SceneRendererTest, OnlyTheMapsAMovedOccluderCanMarkAreDrawnAgain) {
    SceneRenderer kept = renderer();
    draw(kept);
    std::size_t someRedrawn = 0, someSpared = 0;
    for (std::size_t i = 0; i < planned->scene.instances.size(); i += 5) {
        const auto before = planned->instancesInLight;
        glm::dmat4& place = planned->scene.instances[i].worldFromMesh;
        place = glm::translate(glm::dmat4(1.0), {0.05, 0.01, -0.02}) * place;
        const Frame moved = draw(kept);
        std::size_t marked = 0;
        for (std::size_t light = 0; light < planned->lights.size(); ++light) {
            const auto among = [&](const std::vector<std::size_t>& all) { return std::ranges::count(all, i) > 0; };
            if (planned->surfaceLights[light].shadow &&
                (among(before[light]) || among(planned->instancesInLight[light])))
                ++marked;
        }
        EXPECT_EQ(moved.statistics.shafts.shadowMapsDrawn, marked) << "instance " << i;
        EXPECT_EQ(moved.statistics.imagesUploaded, 0u);
        someRedrawn += marked;
        someSpared += mapsCalledFor() - marked;
        if (i % 50 == 0) expectAsFresh(moved);
    }
    EXPECT_GT(someRedrawn, 0u);
    EXPECT_GT(someSpared, 0u);
}

TEST_F(SceneRendererTest, AMovedLightRedrawsItsOwnMap) {
    SceneRenderer kept = renderer();
    draw(kept);
    const auto lit = std::ranges::find_if(planned->surfaceLights, &SurfaceLight::shadow);
    ASSERT_NE(lit, planned->surfaceLights.end());
    Light& light = planned->lights[static_cast<std::size_t>(lit - planned->surfaceLights.begin())];
    light.worldFromLight = glm::rotate(light.worldFromLight, 0.02, {1.0, 0.0, 0.0});
    const Frame moved = draw(kept);
    EXPECT_EQ(moved.statistics.shafts.shadowMapsDrawn, 1u);
    expectAsFresh(moved);
}

TEST_F(SceneRendererTest, AnotherSizeOfPictureAndMaps) {
    SceneRenderer kept = renderer();
    draw(kept);
    view.size = {48, 48};
    shafts.plan.shadowMapSize = 32;
    planned->view = viewFrom(*planned->camera, view.size);
    const Frame other = draw(kept);
    EXPECT_EQ(other.picture.width, 48u);
    EXPECT_EQ(other.statistics.shafts.shadowMapsDrawn, mapsCalledFor()) << "all are of another size";
    expectAsFresh(other);
}

TEST_F(SceneRendererTest, FewerMapsThanLightsThatEverCalledForOne) {
    view.layer = Layer::Shafts;
    SceneRenderer kept = renderer();
    // Turns round twice in the middle of the stage, with a few lights in view at a time: maps pass from light to light,
    // and lights that lost their map need one again.
    planned->view = perspectiveView(planned->view.worldFromView, 0.3, 16.0 / 9.0, 0.1, 1000.0);
    std::vector<bool> called(planned->lights.size());
    std::vector<Image> firstRound;
    std::size_t maxMaps = 0;
    for (int step = 0; step < 24; ++step) {
        planned->view.worldFromView = glm::rotate(
            glm::translate(glm::dmat4(1.0), 0.5 * (planned->scene.bounds.minimum + planned->scene.bounds.maximum)),
            0.5235987755982988 * (step % 12), {0.0, 1.0, 0.0});
        const Frame frame = draw(kept);
        std::size_t now = 0;
        for (std::size_t light = 0; light < called.size(); ++light)
            if (kept.shadowMaps().image(light)) {
                called[light] = true;
                ++now;
            }
        maxMaps = std::max(maxMaps, now);
        if (step < 12) firstRound.push_back(frame.picture);
        EXPECT_TRUE(frame.picture.values == firstRound[static_cast<std::size_t>(step % 12)].values) << "step " << step;
    }
    EXPECT_EQ(kept.shadowMaps().count(), maxMaps);
    EXPECT_LT(maxMaps, static_cast<std::size_t>(std::ranges::count(called, true))) << "else this tests nothing";
}

TEST_F(SceneRendererTest, ForcedPaysForEverything) {
    shafts.plan.everything = true;
    view.layer = Layer::Shafts;
    turnAway();
    SceneRenderer all = renderer();
    const Frame forced = draw(all);
    EXPECT_EQ(forced.statistics.imagesUploaded, planned->scene.images.size());
    EXPECT_EQ(forced.statistics.shafts.shadowMapsDrawn, planned->lights.size());
}

}  // namespace
}  // namespace tyndall::test
