#include "capture/round_cone.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>

#include "core/base/assert.h"

namespace posecoach {
namespace {

using Float3 = glm::vec3;

// Results of the mathematics library differ in their last bits from machine to machine; rounded to a multiple
// of a small power of two they do not.
float snapped(double value) {
  return static_cast<float>(std::nearbyint(value * 1048576.0) / 1048576.0);
}
Float3 snapped(const Vec3& v) {
  return {snapped(v.x), snapped(v.y), snapped(v.z)};
}

struct View {
  Float3 right, down, forward, eye;  // the camera's axes in the world
  float focal_px, pixel_size, centre_x, centre_y;

  explicit View(const PinholeCamera& camera)
      : right(snapped(glm::transpose(camera.rotation_camera_from_world)[0])),
        down(snapped(glm::transpose(camera.rotation_camera_from_world)[1])),
        forward(snapped(glm::transpose(camera.rotation_camera_from_world)[2])),
        eye(snapped(camera.position())),
        focal_px(snapped(camera.focal_px)),
        pixel_size(1.0F / focal_px),
        centre_x(snapped(camera.centre_px.x)),
        centre_y(snapped(camera.centre_px.y)) {}

  // In the camera's axes, towards the image point, one metre deep: distances along it are depths.
  Float3 ray(float x_px, float y_px) const {
    return {(x_px - centre_x) * pixel_size, (y_px - centre_y) * pixel_size, 1.0F};
  }
  Float3 to_camera(const Float3& world) const {
    const Float3 v = world - eye;
    return {glm::dot(v, right), glm::dot(v, down), glm::dot(v, forward)};
  }
  Float3 direction_to_world(const Float3& v) const { return right * v.x + down * v.y + forward * v.z; }
};

constexpr float kFar = 1e9F;

// A cone in the camera's axes, where the eye is the origin, with what every ray needs worked out before.
//
// With p = t d - a for a ray d, h = p.w along the axis w: the side of the cone are the points whose distance
// from the axis, times c, is begin_radius - s h, where s is the sine of the half opening angle and c its
// cosine.
struct PreparedCone {
  enum class Part : std::uint8_t { Begin, Side, End };

  Float3 begin, end, axis;
  float length, begin_radius, end_radius;
  float sine, cosine;
  float side_constant, begin_constant, end_constant;
  float begin_along;  // -begin . axis
  Colour colour;

  PreparedCone(const RoundCone& cone, const View& view)
      : begin(view.to_camera(snapped(cone.begin))),
        end(view.to_camera(snapped(cone.end))),
        begin_radius(snapped(cone.begin_radius)),
        end_radius(snapped(cone.end_radius)),
        colour(cone.colour) {
    const Float3 along = end - begin;
    length = std::sqrt(glm::dot(along, along));
    if (length <= std::abs(begin_radius - end_radius) + 1e-6F) {  // one ball holds the other
      if (begin_radius < end_radius) begin = end;
      begin_radius = end_radius = std::max(begin_radius, end_radius);
      end = begin;
      length = 0;
      axis = Float3(0, 1, 0);
    } else {
      axis = along / length;
    }
    sine = length > 0 ? (begin_radius - end_radius) / length : 0.0F;
    cosine = std::sqrt(1.0F - sine * sine);
    begin_along = -glm::dot(begin, axis);
    begin_constant = glm::dot(begin, begin) - begin_radius * begin_radius;
    end_constant = glm::dot(end, end) - end_radius * end_radius;
    side_constant = cosine * cosine * glm::dot(begin, begin) - begin_along * begin_along +
                    2 * begin_radius * sine * begin_along - begin_radius * begin_radius;
  }

  // Where the ray enters the cone, if it does.
  struct Touch {
    float depth = 0;
    Part part = Part::Side;
    float along = 0;
  };
  std::optional<Touch> touch(const Float3& ray) const {
    const float squared = glm::dot(ray, ray);
    const float begin_on_ray = glm::dot(begin, ray);
    Touch nearest{kFar, Part::Side, 0};
    if (length > 0) {
      const float axis_on_ray = glm::dot(axis, ray);
      const float a = cosine * cosine * squared - axis_on_ray * axis_on_ray;
      const float b =
          begin_radius * sine * axis_on_ray - cosine * cosine * begin_on_ray - begin_along * axis_on_ray;
      const float discriminant = b * b - a * side_constant;
      if (discriminant < 0 && a > 0) return std::nullopt;  // misses even the endless cone
      if (discriminant >= 0 && std::abs(a) > 1e-9F) {
        const float root = std::sqrt(discriminant);
        const Touch first = side((-b - root) / a, axis_on_ray), second = side((-b + root) / a, axis_on_ray);
        // Where the ray enters the endless cone it enters this one, if it is there at all.
        if (a > 0 && first.depth < kFar) return first;
        nearest = first.depth < second.depth ? first : second;
      }
    }
    const Touch begin_ball{ball(squared, begin_on_ray, begin_constant), Part::Begin, 0};
    if (begin_ball.depth < nearest.depth) nearest = begin_ball;
    if (length > 0) {
      const Touch end_ball{ball(squared, glm::dot(end, ray), end_constant), Part::End, 0};
      if (end_ball.depth < nearest.depth) nearest = end_ball;
    }
    return nearest.depth < kFar ? std::optional(nearest) : std::nullopt;
  }

  Float3 normal(const Float3& ray, const Touch& touch) const {
    const Float3 point = ray * touch.depth;
    if (touch.part == Part::Begin) return (point - begin) / begin_radius;
    if (touch.part == Part::End) return (point - end) / end_radius;
    const Float3 radial = point - begin - axis * touch.along;
    const float radius = std::sqrt(glm::dot(radial, radial));
    return radius < 1e-9F ? axis * sine : radial * (cosine / radius) + axis * sine;
  }

 private:
  Touch side(float depth, float axis_on_ray) const {
    const float along = begin_along + depth * axis_on_ray;
    const bool is_here = depth > 0 && along >= begin_radius * sine && along <= length + end_radius * sine;
    return {is_here ? depth : kFar, Part::Side, along};
  }
  static float ball(float squared, float centre_on_ray, float constant) {
    const float discriminant = centre_on_ray * centre_on_ray - squared * constant;
    if (discriminant < 0 || centre_on_ray <= 0) return kFar;
    return (centre_on_ray - std::sqrt(discriminant)) / squared;
  }
};

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

// Daylight from above, a little from the left behind the camera.
Colour shaded(const Colour& colour, const Float3& normal_world, const Float3& light) {
  const float sun = std::max(0.0F, glm::dot(normal_world, light));
  const float sky = 0.5F + 0.5F * normal_world.y;
  const float brightness = 0.50F + 0.18F * sky + 0.42F * sun;
  return {colour[0] * brightness, colour[1] * brightness, colour[2] * brightness};
}

struct PixelRange {
  int begin = 0, end = 0;
  void include(const PixelRange& other) {
    if (other.begin >= other.end) return;
    *this = begin >= end ? other : PixelRange{std::min(begin, other.begin), std::max(end, other.end)};
  }
};

// What of a row's pixels a cone's outline can touch. The outline lies inside the hull of two discs, whose
// radius and centre change linearly between them.
class Outline {
 public:
  Outline(const PreparedCone& cone, const View& view) {
    const auto disc = [&](const Float3& centre, float radius) {
      const float depth = std::max(centre.z - radius, 0.05F);
      const float slope = std::sqrt(centre.x * centre.x + centre.y * centre.y) / depth;
      return Disc{view.centre_x + view.focal_px * centre.x / centre.z,
                  view.centre_y + view.focal_px * centre.y / centre.z,
                  view.focal_px * radius / depth * std::sqrt(1 + slope * slope) + 1.0F};
    };
    visible_ = cone.begin.z > 0.1F && cone.end.z > 0.1F;
    if (!visible_) return;
    begin_ = disc(cone.begin, cone.begin_radius);
    end_ = disc(cone.end, cone.end_radius);
  }

  PixelRange rows(int height) const {
    if (!visible_) return {0, 0};
    return clamped(std::min(begin_.y - begin_.radius, end_.y - end_.radius),
                   std::max(begin_.y + begin_.radius, end_.y + end_.radius), height);
  }

  PixelRange columns(int row, int width) const {
    const float y = static_cast<float>(row) + 0.5F;
    float low = 0, high = 1;  // the part of the axis whose discs touch the row
    limit(begin_.y - begin_.radius - y, end_.y - end_.radius - y, low, high);
    limit(y - begin_.y - begin_.radius, y - end_.y - end_.radius, low, high);
    if (low > high) return {0, 0};
    const auto at = [&](float part, float sign) {
      return begin_.x + part * (end_.x - begin_.x) +
             sign * (begin_.radius + part * (end_.radius - begin_.radius));
    };
    return clamped(std::min(at(low, -1), at(high, -1)), std::max(at(low, 1), at(high, 1)), width);
  }

 private:
  struct Disc {
    float x = 0, y = 0, radius = 0;
  };
  // Keeps the part where a value that goes linearly from `first` to `last` is not positive.
  static void limit(float first, float last, float& low, float& high) {
    if (first <= 0 && last <= 0) return;
    if (first > 0 && last > 0) {
      low = 1;
      high = 0;
    } else if (first > 0) {
      low = std::max(low, first / (first - last));
    } else {
      high = std::min(high, first / (first - last));
    }
  }
  static PixelRange clamped(float low, float high, int size) {
    const float limit = static_cast<float>(size);
    return {static_cast<int>(std::clamp(std::floor(low), 0.0F, limit)),
            static_cast<int>(std::clamp(std::ceil(high) + 1.0F, 0.0F, limit))};
  }

  bool visible_ = false;
  Disc begin_, end_;
};

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

  Colour colour_of(const PreparedCone& cone, const Float3& normal) const {
    return shaded(cone.colour, view_.direction_to_world(normal), light_);
  }

  void write(int x, int y, const Colour& colour) {
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
    Colour sum{};
    for (const auto& sample : kSamples) {
      const Float3 ray = view_.ray(static_cast<float>(x) + sample[0], static_cast<float>(y) + sample[1]);
      float nearest = kFar;
      Colour colour{static_cast<float>(behind[0]) / 255.0F, static_cast<float>(behind[1]) / 255.0F,
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

// The same grain for a place on the ground whatever the camera sees of it.
float grain(float x, float z) {
  const auto cell = [](float v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v * 24.0F)));
  };
  std::uint32_t bits = cell(x) * 0x9E3779B1U ^ cell(z) * 0x85EBCA77U;
  bits ^= bits >> 15;
  bits *= 0x2C1B3C6DU;
  bits ^= bits >> 12;
  return static_cast<float>(bits & 0xFFU) / 255.0F - 0.5F;
}

}  // namespace

Image draw_ground_and_sky(const PinholeCamera& camera) {
  const View view(camera);
  Image image = Image::black(camera.width_px, camera.height_px);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Float3 ray = glm::normalize(
          view.direction_to_world(view.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)));
      Colour colour;
      if (ray.y >= 0) {
        const float up = std::min(1.0F, ray.y * 2.2F);
        colour = {0.83F - 0.33F * up, 0.89F - 0.20F * up, 0.95F - 0.04F * up};
      } else {
        const float distance = std::min(60.0F, -view.eye.y / std::min(ray.y, -1e-4F));
        const float ground_x = view.eye.x + ray.x * distance, ground_z = view.eye.z + ray.z * distance;
        const float haze = distance / 60.0F;
        const float stripe =
            std::floor(ground_x * 0.5F) - 2.0F * std::floor(ground_x * 0.25F) > 0.5F ? 0.014F : -0.014F;
        const float speckle =
            distance < 14.0F ? 0.035F * grain(ground_x, ground_z) * (1.0F - distance / 14.0F) : 0.0F;
        const float near = 1.0F - haze;
        colour = {0.33F + 0.30F * haze + (speckle + stripe) * near,
                  0.52F + 0.22F * haze + (speckle + stripe) * near,
                  0.24F + 0.36F * haze + (speckle * 0.6F + stripe) * near};
      }
      for (std::size_t c = 0; c < 3; ++c) image.pixel(x, y)[c] = to_byte(colour[c]);
    }
  return image;
}

Image draw_scene(const ConeScene& scene, const PinholeCamera& camera, const Image& background) {
  POSECOACH_ASSERT(scene.cones.size() < 65535);
  return SceneDrawing(scene, camera, background).draw(scene.shadows);
}

}  // namespace posecoach
