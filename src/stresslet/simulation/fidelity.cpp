#include "stresslet/simulation/fidelity.hpp"

#include "stresslet/io/schema_read.hpp"

namespace stresslet {

Fidelity fidelity_of(InputDocument& document) {
  const InputValue* value = document.look_up(fidelity_key);
  if (!value) return Fidelity::lubricated;
  const KeyInfo key{fidelity_key, defaulted, completed<Fidelity>({}), "", "How closely the fluid is followed"};
  if (!std::holds_alternative<std::string>(value->content)) refuse_kind(*value, key, InputType<Fidelity>::name);
  check_value(*value, key);
  return InputType<Fidelity>::read(*value).value();
}

}  // namespace stresslet
