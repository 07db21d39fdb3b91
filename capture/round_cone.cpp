#include "capture/round_cone.h"

#include <algorithm>
#include <cmath>

#include "capture/cone_outline.h"
#include "capture/cone_ray.h"
#include "core/base/assert.h"

namespace posecoach {
namespace {

using namespace cone_ray;

// Daylight from above, a little from the left behind the camera.
SurfaceColour shaded(const SurfaceColour& colour, const Float3& normal_world, const Float3& light) {
  const float sun = std::max(0.0F, glm::dot(normal_world, light));
  const float sky = 0.5F + 0.5F * normal_world.y;
  const float brightness = 0.50F + 0.18F * sky + 0.42F * sun;
  return {colour[0] * brightness, colour[1] * brightness, colour[2] * brightness};
}

class SceneDrawing {
 public:
  SceneDrawing(const ConeScene& scene, const PinholeCamera& camera, const Image& background)
      : view_(camera), image_(background), touched_(static_cast<std::size_t>(background.height)) {
    POSECOACH_ASSERT(background.width == camera.width_px && background.height == camera.height_px);
    for (const RoundCone& cone : scene.cones) cones_.emplace_back(cone, view_);
    // The light comes over the viewer's left shoulder wherever he stands.
    light_ = glm::normalize(Float3(0, 0.75F, 0) - view_.right * 0.35F - view_.forward * 0.55F);
  }

  Image draw(const std::vector<GroundShadow>& shadows) {
    draw_shadows(shadows);
    cast_cones();
    shade();
    return std::move(image_);
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
  }

  void draw_shadows(const std::vector<GroundShadow>& shadows) {
    if (shadows.empty()) return;
    const PreparedShadows prepared(shadows);
    const PixelRange rows = rows_of_ground(prepared);
    for (int y = rows.begin; y < rows.end; ++y)
      for (int x = 0; x < image_.width; ++x) {
        const Float3 ray = view_.direction_to_world(middle_ray(x, y));
        if (ray.y > -0.02F) break;  // the horizon is level: the whole row is sky
        const float depth = -view_.eye.y / ray.y;
        const float ground_x = view_.eye.x + ray.x * depth, ground_z = view_.eye.z + ray.z * depth;
        if (!prepared.may_touch(ground_x, ground_z)) continue;
        const float light = prepared.light(ground_x, ground_z);
        std::uint8_t* pixel = image_.pixel(x, y);
        for (int c = 0; c < 3; ++c)
          pixel[c] = static_cast<std::uint8_t>(static_cast<float>(pixel[c]) * light + 0.5F);
      }
  }

  struct PreparedShadows {
    struct Spot {
      float x, z, along_x, along_z, inverse_length_squared, inverse_radius_squared, reach, strength;
    };
    std::vector<Spot> spots;
    float low_x = kFar, high_x = -kFar, low_z = kFar, high_z = -kFar;

    explicit PreparedShadows(const std::vector<GroundShadow>& shadows) {
      for (const GroundShadow& shadow : shadows) {
        const Float3 begin = snapped(shadow.begin), along = snapped(shadow.end) - begin;
        const float radius = snapped(shadow.radius);
        const float squared = along.x * along.x + along.z * along.z;
        spots.push_back({begin.x, begin.z, along.x, along.z, squared > 1e-9F ? 1.0F / squared : 0.0F,
                         1.0F / (radius * radius), radius, snapped(shadow.strength)});
        low_x = std::min({low_x, begin.x - radius, begin.x + along.x - radius});
        high_x = std::max({high_x, begin.x + radius, begin.x + along.x + radius});
        low_z = std::min({low_z, begin.z - radius, begin.z + along.z - radius});
        high_z = std::max({high_z, begin.z + radius, begin.z + along.z + radius});
      }
    }
    bool may_touch(float x, float z) const { return x > low_x && x < high_x && z > low_z && z < high_z; }
    float light(float x, float z) const {
      float light = 1;
      for (const Spot& spot : spots) {
        const float dx = x - spot.x, dz = z - spot.z;
        const float part =
            std::clamp((dx * spot.along_x + dz * spot.along_z) * spot.inverse_length_squared, 0.0F, 1.0F);
        const float off_x = dx - part * spot.along_x, off_z = dz - part * spot.along_z;
        const float fall = 1.0F - (off_x * off_x + off_z * off_z) * spot.inverse_radius_squared;
        if (fall > 0) light *= 1.0F - spot.strength * fall * fall;
      }
      return light;
    }
  };

  // The camera stands level, so a shadow's rows are those of its nearest and farthest corner.
  PixelRange rows_of_ground(const PreparedShadows& shadows) const {
    float low = static_cast<float>(image_.height), high = 0;
    for (const float x : {shadows.low_x, shadows.high_x})
      for (const float z : {shadows.low_z, shadows.high_z}) {
        const Float3 corner = view_.to_camera(Float3(x, 0, z));
        if (corner.z < 0.1F) return {0, image_.height};
        const float row = view_.centre_y + view_.focal_px * corner.y / corner.z;
        low = std::min(low, row);
        high = std::max(high, row);
      }
    const float limit = static_cast<float>(image_.height);
    return {static_cast<int>(std::clamp(low - 1, 0.0F, limit)),
            static_cast<int>(std::clamp(high + 2, 0.0F, limit))};
  }

  void cast_cones() {
    depth_.assign(at(0, image_.height), kFar);
    nearest_.assign(depth_.size(), 0);
    touches_.resize(depth_.size());
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const Outline outline(cones_[i], view_);
      const PixelRange rows = outline.rows(image_.height);
      for (int y = rows.begin; y < rows.end; ++y) {
        const PixelRange columns = outline.columns(y, image_.width);
        touched_[static_cast<std::size_t>(y)].include(columns);
        for (int x = columns.begin; x < columns.end; ++x) {
          const auto touch = cones_[i].touch(middle_ray(x, y));
          if (!touch || touch->depth >= depth_[at(x, y)]) continue;
          depth_[at(x, y)] = touch->depth;
          touches_[at(x, y)] = *touch;
          nearest_[at(x, y)] = static_cast<std::uint16_t>(i + 1);
        }
      }
    }
  }

  void shade() {
    for (int y = 0; y < image_.height; ++y) {
      // A row's edges may belong to its neighbours' cones.
      PixelRange columns = touched_[static_cast<std::size_t>(y)];
      for (const int other : {std::max(0, y - 1), std::min(image_.height - 1, y + 1)})
        columns.include(touched_[static_cast<std::size_t>(other)]);
      for (int x = std::max(0, columns.begin - 1); x < std::min(image_.width, columns.end + 1); ++x) {
        const std::uint16_t here = nearest_[at(x, y)];
        if (is_edge(x, y)) {
          shade_edge(x, y);
        } else if (here != 0) {
          const PreparedCone& cone = cones_[here - 1U];
          write(x, y, colour_of(cone, cone.normal(middle_ray(x, y), touches_[at(x, y)])));
        }
      }
    }
  }

  Float3 middle_ray(int x, int y) const {
    return view_.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  }

  SurfaceColour colour_of(const PreparedCone& cone, const Float3& normal) const {
    return shaded(cone.colour, view_.direction_to_world(normal), light_);
  }

  void write(int x, int y, const SurfaceColour& colour) {
    for (std::size_t c = 0; c < 3; ++c) image_.pixel(x, y)[c] = to_byte(colour[c]);
  }

  bool is_edge(int x, int y) const {
    const std::uint16_t here = nearest_[at(x, y)];
    return (x > 0 && nearest_[at(x - 1, y)] != here) ||
           (x + 1 < image_.width && nearest_[at(x + 1, y)] != here) ||
           (y > 0 && nearest_[at(x, y - 1)] != here) ||
           (y + 1 < image_.height && nearest_[at(x, y + 1)] != here);
  }

  // Four rays, against what the neighbours saw.
  void shade_edge(int x, int y) {
    std::array<std::uint16_t, 9> seen{};
    std::size_t count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(image_.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(image_.width - 1, x + 1); ++u) {
        const std::uint16_t cone = nearest_[at(u, v)];
        if (cone != 0 && std::find(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(count), cone) ==
                             seen.begin() + static_cast<std::ptrdiff_t>(count))
          seen[count++] = cone;
      }
    static constexpr std::array<std::array<float, 2>, 4> kSamples = {
        {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}}};
    const std::uint8_t* behind = image_.pixel(x, y);
    SurfaceColour sum{};
    for (const auto& sample : kSamples) {
      const Float3 ray = view_.ray(static_cast<float>(x) + sample[0], static_cast<float>(y) + sample[1]);
      float nearest = kFar;
      SurfaceColour colour{static_cast<float>(behind[0]) / 255.0F, static_cast<float>(behind[1]) / 255.0F,
                           static_cast<float>(behind[2]) / 255.0F};
      for (std::size_t i = 0; i < count; ++i) {
        const PreparedCone& cone = cones_[seen[i] - 1U];
        const auto touch = cone.touch(ray);
        if (!touch || touch->depth >= nearest) continue;
        nearest = touch->depth;
        colour = colour_of(cone, cone.normal(ray, *touch));
      }
      for (std::size_t c = 0; c < 3; ++c) sum[c] += std::min(colour[c], 1.0F) * 0.25F;
    }
    write(x, y, sum);
  }

  View view_;
  Image image_;
  Float3 light_;
  std::vector<PreparedCone> cones_;
  std::vector<float> depth_;
  std::vector<std::uint16_t> nearest_;  // 1 + index of the cone; 0 for none
  std::vector<PreparedCone::Touch> touches_;
  std::vector<PixelRange> touched_;  // of every row
};

}  // namespace

Image draw_scene(const ConeScene& scene, const PinholeCamera& camera, const Image& background) {
  POSECOACH_ASSERT(scene.cones.size() < 65535);
  return SceneDrawing(scene, camera, background).draw(scene.shadows);
}

}  // namespace posecoach
