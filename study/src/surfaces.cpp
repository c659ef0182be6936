#include "surfaces.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tyndall::study {

struct Surfaces::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Triangle> triangles;  // view space

    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();

// Drops hits on the back of a one-sided triangle: as in glTF, it is invisible.
void keepVisible(const RTCFilterFunctionNArguments* arguments) {
    const auto& triangles = *static_cast<const std::vector<Triangle>*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const RTCRay ray = rtcGetRayFromRayN(arguments->ray, arguments->N, i);
        const RTCHit hit = rtcGetHitFromHitN(arguments->hit, arguments->N, i);
        const float facing = ray.dir_x * hit.Ng_x + ray.dir_y * hit.Ng_y + ray.dir_z * hit.Ng_z;
        if (facing > 0.0f && !triangles[hit.primID].bothSides) arguments->valid[i] = 0;
    }
}

RTCRay embreeRay(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) {
    const glm::vec3 o(origin), d(direction);
    return {o.x, o.y, o.z, static_cast<float>(begin), d.x, d.y, d.z, 0.0f, static_cast<float>(end), ~0u, 0, 0};
}

}  // namespace

Surfaces::Surfaces(const View& view, const std::vector<Triangle>& triangles) : impl_(std::make_unique<Impl>()) {
    const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(view.worldFromView));
    const glm::dvec3 eye(view.worldFromView[3]);
    impl_->triangles.reserve(triangles.size());
    for (const Triangle& t : triangles)
        impl_->triangles.push_back(
            {viewFromWorld * (t.a - eye), viewFromWorld * (t.b - eye), viewFromWorld * (t.c - eye), t.bothSides});

    impl_->device = rtcNewDevice(nullptr);
    if (!impl_->device) throw std::runtime_error("Embree could not be started");
    impl_->scene = rtcNewScene(impl_->device);
    rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) {
        const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* corners = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles.size()));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
        if (!corners || !indices) throw std::bad_alloc();
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = impl_->triangles[i];
            for (const glm::dvec3& p : {t.a, t.b, t.c})
                for (int axis = 0; axis < 3; ++axis) *corners++ = static_cast<float>(p[axis]);
            for (unsigned corner = 0; corner < 3; ++corner) *indices++ = static_cast<unsigned>(3 * i) + corner;
        }
        rtcSetGeometryUserData(geometry, &impl_->triangles);
        rtcSetGeometryIntersectFilterFunction(geometry, keepVisible);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(impl_->scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(impl_->scene);
}

Surfaces::Surfaces(Surfaces&&) noexcept = default;
Surfaces& Surfaces::operator=(Surfaces&&) noexcept = default;
Surfaces::~Surfaces() = default;

double Surfaces::firstHit(const ViewRay& ray, double begin, double end) const {
    RTCRayHit query{};
    query.ray = embreeRay(ray.origin, ray.direction, begin, end);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(impl_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::numeric_limits<double>::infinity();

    const Triangle& t = impl_->triangles[query.hit.primID];
    const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
    const double distance = glm::dot(normal, t.a - ray.origin) / glm::dot(normal, ray.direction);
    // A triangle seen exactly edge on gives no plane; Embree's distance is used then.
    return std::isfinite(distance) ? std::clamp(distance, begin, end) : static_cast<double>(query.ray.tfar);
}

bool Surfaces::blocked(const glm::dvec3& from, const glm::dvec3& to) const {
    RTCRay query = embreeRay(from, to - from, 0.0, 1.0);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(impl_->scene, &context, &query);
    return query.tfar == -unbounded;
}

}  // namespace tyndall::study
