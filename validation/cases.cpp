#include "validation/cases.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/io/nearest_word.hpp"

namespace stresslet::validation {

// One function a folder, defined in the folder's source file.
void taylor_green(Trial&);
void shear_wave(Trial&);
void poiseuille(Trial&);
void couette(Trial&);
void square_duct(Trial&);
void womersley(Trial&);
void stokes_first_problem(Trial&);
void cylindrical_couette(Trial&);
void kelvin_mode(Trial&);
void sheared_profile(Trial&);
void lid_driven_cavity(Trial&);
void force_schemes(Trial&);
void free_sphere(Trial&);
void box_height(Trial&);
void resolution(Trial&);
void fixed_sphere(Trial&);
void profiles(Trial&);
void pair_in_shear(Trial&);
void stress_balance(Trial&);
void pair_resistance(Trial&);
void stimson_jeffery(Trial&);
void sphere_wall(Trial&);
void approach(Trial&);
void passing(Trial&);
void rotating(Trial&);
void cut_off(Trial&);
void settling(Trial&);
void drafting_kissing_tumbling(Trial&);
void wet_bounce(Trial&);
void cubic_array(Trial&);
void sheared_lattice(Trial&);

namespace {

constexpr Case list[] = {
    {"L1", "L01-taylor-green", "Taylor-Green vortices", taylor_green},
    {"L2", "L02-shear-wave", "decay of a shear wave, straight and tilted", shear_wave},
    {"L3", "L03-poiseuille", "plane Poiseuille flow between half-way walls", poiseuille},
    {"L4", "L04-couette", "plane Couette flow between moving walls", couette},
    {"L5", "L05-square-duct", "flow along a square duct", square_duct},
    {"L6", "L06-womersley", "oscillating flow between plates", womersley},
    {"L7", "L07-stokes-first-problem", "a plate set moving in a fluid at rest", stokes_first_problem},
    {"L8", "L08-cylindrical-couette", "flow between cylinders made of voxels", cylindrical_couette},
    {"L9", "L09-kelvin-mode", "Kelvin mode under the sheared boundary", kelvin_mode},
    {"L10", "L10-sheared-profile", "relaxation to the linear profile under the sheared boundary", sheared_profile},
    {"L12", "L12-lid-driven-cavity", "lid-driven cavity at Reynolds number 100", lid_driven_cavity},
    {"L13", "L13-force-schemes", "uniform force: what each forcing law leaves", force_schemes},
    {"A1", "A1-free-sphere", "free sphere in shear, schemes of published work", free_sphere},
    {"A2", "A2-box-height", "walls near a sphere in shear", box_height},
    {"A3", "A3-resolution", "resolution of a sphere in shear, schemes of published work", resolution},
    {"A4", "A4-fixed-sphere", "torque and stresslet of a sphere held in shear", fixed_sphere},
    {"A5", "A5-profiles", "velocity through a free sphere in shear", profiles},
    {"A6", "A6-pair-in-shear", "two spheres in shear: free, turning, held", pair_in_shear},
    {"B1", "B1-approach", "two spheres approach, gap of one cell", approach},
    {"B2", "B2-passing", "two spheres pass each other", passing},
    {"B3", "B3-rotating", "two spheres turn alike", rotating},
    {"B4", "B4-cut-off", "two spheres approach, lubrication corrected below a cut-off", cut_off},
    {"stress-balance", "stress-balance", "what walls feel of a sphere, every operator and weight", stress_balance},
    {"pair-resistance", "pair-resistance", "two spheres: approach, resistance functions, extension", pair_resistance},
    {"stimson-jeffery", "stimson-jeffery", "two spheres that follow each other", stimson_jeffery},
    {"sphere-wall", "sphere-wall", "a sphere above a plane wall", sphere_wall},
    {"settling", "settling", "a sphere settles in a closed box", settling},
    {"drafting-kissing-tumbling", "drafting-kissing-tumbling", "two spheres settle one above the other",
     drafting_kissing_tumbling},
    {"wet-bounce", "wet-bounce", "restitution of a wet impact by Stokes number", wet_bounce},
    {"cubic-array", "cubic-array", "drag and viscosity of cubic arrays of spheres", cubic_array},
    {"sheared-lattice", "sheared-lattice", "cubic lattice of free spheres in shear", sheared_lattice},
};

}  // namespace

std::span<const Case> cases() { return list; }

const Case& case_called(std::string_view id) {
  const auto found = std::ranges::find(list, id, &Case::id);
  if (found != std::end(list)) return *found;
  std::vector<std::string> known;
  for (const Case& c : list) known.emplace_back(c.id);
  const auto near = nearest_word(id, known);
  throw InputError({"", "there is no validation case \"" + std::string(id) + "\"",
                    "known cases: " + comma_separated(known),
                    near ? "did you mean " + *near + "?" : "stresslet validate list shows what each is"});
}

}  // namespace stresslet::validation
