#pragma once
/// The words of the input that choose a law or a scheme, in one place.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stresslet/dem/contact/coulomb_limit.hpp"
#include "stresslet/io/schema.hpp"
#include "stresslet/particles/box.hpp"

namespace stresslet {

/// Names in NormalContactLaws, LubricationLaws and TimeSchemes.
std::vector<std::string> normal_contact_law_names();
std::vector<std::string> lubrication_law_names();
std::vector<std::string> time_scheme_names();

enum class SizeLaw { monodisperse, discrete, lognormal, table };
enum class ShareKind { number, volume };

template <>
struct Keywords<BoxKind> {
  static constexpr std::array<std::pair<std::string_view, BoxKind>, 3> names{
      {{"lees-edwards", BoxKind::lees_edwards}, {"walls", BoxKind::walls}, {"periodic", BoxKind::periodic}}};
};

template <>
struct Keywords<SizeLaw> {
  static constexpr std::array<std::pair<std::string_view, SizeLaw>, 4> names{{{"monodisperse", SizeLaw::monodisperse},
                                                                              {"discrete", SizeLaw::discrete},
                                                                              {"lognormal", SizeLaw::lognormal},
                                                                              {"table", SizeLaw::table}}};
};

template <>
struct Keywords<ShareKind> {
  static constexpr std::array<std::pair<std::string_view, ShareKind>, 2> names{
      {{"number", ShareKind::number}, {"volume", ShareKind::volume}}};
};

template <>
struct Keywords<CoulombLimit> {
  static constexpr std::array<std::pair<std::string_view, CoulombLimit>, 2> names{
      {{"spring", CoulombLimit::spring}, {"spring-dashpot", CoulombLimit::spring_and_dashpot}}};
};

/// The switches of the lubricated model.
struct ModelSwitches {
  std::string_view lubrication;
  bool drag;       ///< Stokes drag and torque in the imposed flow
  bool stresslet;  ///< single-sphere stresslet in the stress

  friend bool operator==(const ModelSwitches&, const ModelSwitches&) = default;
};

struct NamedModel {
  std::string_view name;
  ModelSwitches switches;
};

/// The models of Najuch (2018), PhD thesis, University of Edinburgh, chapter 5.
inline constexpr std::array<NamedModel, 6> named_models{{
    {"NLM", {"normal", false, false}},
    {"CLM", {"complete", false, false}},
    {"NLM-S", {"normal", true, true}},
    {"CLM-S", {"complete", true, true}},
    {"CLM-SS", {"complete", false, true}},
    {"GRM", {"grand-resistance", true, true}},
}};

inline std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const NamedModel& model : named_models) names.emplace_back(model.name);
  return names;
}

inline std::optional<ModelSwitches> switches_of_model(std::string_view name) {
  for (const NamedModel& model : named_models)
    if (model.name == name) return model.switches;
  return std::nullopt;
}

}  // namespace stresslet
