#include "calibration_file.hpp"

#include <fmt/format.h>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/provenance.hpp"

namespace stresslet {

nlohmann::ordered_json lengths_json(const SubgridLengths& l) {
  return {{"normal", l.normal}, {"sliding", l.sliding}, {"spin", l.spin}};
}

void print_lengths(const CalibrateArguments& a, const SubgridLengths& lengths) {
  fmt::print("{} {} {} tau {:g}, {}{}: lengths in cells: normal {:.3f}, sliding {:.3f}, spin {:.3f}\n",
             a.scheme.coupling_operator, a.scheme.weight, a.scheme.collision, a.scheme.relaxation_time, a.law,
             a.wall ? " at walls" : "", lengths.normal, lengths.sliding, lengths.spin);
}

void write_calibration(const CalibrateArguments& a, const nlohmann::ordered_json& results) {
  const Provenance p = provenance(a.command_line, a.threads, 0);
  nlohmann::ordered_json document{{"provenance",
                                   {{"version", p.version},
                                    {"commit", p.commit},
                                    {"compiler", p.compiler},
                                    {"date", p.date},
                                    {"command_line", p.command_line}}},
                                  {"scheme",
                                   {{"operator", a.scheme.coupling_operator},
                                    {"weight", a.scheme.weight},
                                    {"solid_fraction", a.scheme.solid_fraction},
                                    {"collision", a.scheme.collision},
                                    {"relaxation_time", a.scheme.relaxation_time},
                                    {"magic_parameter", a.scheme.magic_parameter}}},
                                  {"law", a.law}};
  document.update(results);
  replace_file(a.output, document.dump(1) + "\n");
  fmt::print("written: {}\n", a.output);
}

}  // namespace stresslet
