#include "core/transfer/contact_sheet.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace posecoach {
namespace {

constexpr int kCell = 300, kHeader = 34, kBorder = 26;
const cv::Scalar kPaper(250, 250, 250), kLine(225, 225, 225), kText(70, 70, 70), kGuess(190, 190, 190);
// BGR; left limbs darker than right ones, so that a turned body can be told.
const cv::Scalar kPoseColour(20, 150, 235), kIdentityColour(190, 120, 40), kResultColour(160, 50, 130);

struct Placing {
  Vec2 centre;
  double scale = 1;
  cv::Point origin;
  cv::Point at(const Vec2& p) const {
    const Vec2 q = (p - centre) * scale;
    return {origin.x + static_cast<int>(std::lround(q.x)), origin.y + static_cast<int>(std::lround(q.y))};
  }
};

double fitting_scale(const Pose2d& pose) {
  const Vec2 size = bounding_box(pose).size();
  return (kCell - 2 * kBorder) / std::max({size.x, size.y, 1e-9});
}

bool is_left(Joint2d joint) {
  return to_string(joint).starts_with("left");
}

using Certain = std::array<bool, kJoint2dCount>;

void draw_figure(cv::Mat& sheet, const Pose2d& pose, const Placing& place, const cv::Scalar& colour,
                 int thickness, const Certain& certain) {
  const auto shade = [&](Joint2d joint) { return is_left(joint) ? colour * 0.62 : colour; };
  for (const Bone2d& bone : kBones2d) {
    if (!pose.is_seen(bone.parent) || !pose.is_seen(bone.child)) continue;
    const bool sure = certain[index(bone.parent)] && certain[index(bone.child)];
    cv::line(sheet, place.at(pose[bone.parent]), place.at(pose[bone.child]),
             sure ? shade(bone.child) : kGuess, thickness, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    if (!pose.seen[i]) continue;
    const Joint2d joint = static_cast<Joint2d>(i);
    const int radius = joint == Joint2d::Nose ? thickness + 4 : thickness;
    cv::circle(sheet, place.at(pose.positions[i]), radius, certain[i] ? shade(joint) : kGuess,
               certain[i] ? cv::FILLED : 1, cv::LINE_AA);
  }
}

void write_text(cv::Mat& sheet, const std::string& text, cv::Point where) {
  cv::putText(sheet, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.5, kText, 1, cv::LINE_AA);
}

}  // namespace

std::string contact_sheet_png(std::span<const SheetRow> rows) {
  Certain all;
  all.fill(true);
  cv::Mat sheet(kHeader + kCell * static_cast<int>(rows.size()), 3 * kCell, CV_8UC3, kPaper);
  write_text(sheet, "pose", {kBorder, 22});
  write_text(sheet, "person", {kCell + kBorder, 22});
  write_text(sheet, "pose on that person", {2 * kCell + kBorder, 22});
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const SheetRow& row = rows[r];
    const int top = kHeader + kCell * static_cast<int>(r);
    cv::line(sheet, {0, top}, {sheet.cols, top}, kLine);
    const auto cell_centre = [&](int column) {
      return cv::Point(column * kCell + kCell / 2, top + kCell / 2);
    };
    const auto middle = [](const Pose2d& pose) { return bounding_box(pose).centre(); };
    const double shared = std::min(fitting_scale(row.identity), fitting_scale(row.result.pose));
    draw_figure(sheet, row.pose, {middle(row.pose), fitting_scale(row.pose), cell_centre(0)}, kPoseColour, 4,
                all);
    draw_figure(sheet, row.identity, {middle(row.identity), shared, cell_centre(1)}, kIdentityColour, 4, all);
    if (row.truth)
      draw_figure(sheet, *row.truth, {middle(*row.truth), shared, cell_centre(2)}, cv::Scalar(205, 205, 205),
                  9, all);
    Certain certain;
    for (std::size_t i = 0; i < kJoint2dCount; ++i)
      certain[i] = row.pose.seen[i] && row.result.expected_error[i] < kFarOff;
    draw_figure(sheet, row.result.pose, {middle(row.result.pose), shared, cell_centre(2)}, kResultColour, 4,
                certain);
  }
  std::vector<unsigned char> png;
  cv::imencode(".png", sheet, png);
  return {png.begin(), png.end()};
}

}  // namespace posecoach
