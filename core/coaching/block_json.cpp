#include <nlohmann/json.hpp>

#include "core/coaching/block.h"

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;

Json json_from(const Spread& spread) {
  return {{"swings", spread.count}, {"mean", spread.mean}, {"deviation", spread.deviation}};
}

AdviceKind kind_from(const std::string& kind) {
  return kind == "timing" ? AdviceKind::Timing : kind == "spatial" ? AdviceKind::Spatial : AdviceKind::None;
}

Metric metric_from(const nlohmann::json& json) {
  Metric metric;
  metric.name = json.at("name").get<std::string>();
  metric.title = json.value("title", metric.name);
  metric.unit = json.value("unit", "");
  metric.available = json.at("available").get<bool>();
  if (metric.available) metric.value = json.at("value").get<double>();
  if (json.contains("coach")) metric.coach = json.at("coach").get<double>();
  return metric;
}

Advice advice_from(const nlohmann::json& json) {
  Advice advice;
  advice.kind = kind_from(json.at("kind").get<std::string>());
  advice.text = json.at("text").get<std::string>();
  advice.fault = json.value("fault", "");
  advice.measure = json.value("measure", "");
  advice.event = json.value("event", "");
  advice.amount = json.value("amount", 0.0);
  advice.severity = json.value("severity", 0.0);
  return advice;
}

}  // namespace

Result<BlockSwing> block_swing_from_json(std::string_view text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    BlockSwing swing;
    swing.stroke = json.value("stroke", "");
    swing.percent = json.at("score").at("percent").get<double>();
    for (const nlohmann::json& metric : json.at("metrics")) swing.metrics.push_back(metric_from(metric));
    for (const nlohmann::json& advice : json.at("advice")) swing.advice.push_back(advice_from(advice));
    return swing;
  } catch (const nlohmann::json::exception& exception) {
    return fail(ErrorCode::Malformed, std::string("this is no analysis: ") + exception.what());
  }
}

std::string to_json(const Block& block) {
  Json json{{"schema", "posecoach.block/1"},
            {"swings", block.swings},
            {"score_percent", json_from(block.percent)},
            {"words", block.words},
            {"metrics", Json::array()},
            {"advice", Json::array()}};
  for (const MetricSpread& metric : block.metrics) {
    Json one{{"name", metric.name}, {"title", metric.title}, {"unit", metric.unit}};
    one.update(json_from(metric.spread));
    if (metric.coach) one["coach"] = *metric.coach;
    json["metrics"].push_back(std::move(one));
  }
  for (const RepeatedAdvice& advice : block.advice)
    json["advice"].push_back({{"text", advice.text},
                              {"fault", advice.fault},
                              {"measure", advice.measure},
                              {"event", advice.event},
                              {"swings", advice.swings}});
  return json.dump(2) + "\n";
}

}  // namespace posecoach
