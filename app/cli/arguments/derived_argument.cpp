#include "app/cli/arguments/derived_argument.h"

#include <CLI/CLI.hpp>

namespace app {

void declareDerived(CLI::App& command, DerivedArgument& argument) {
    command.add_flag(
        "--shadow-verdicts", argument.shadowVerdicts,
        "Write shadow_verdict.k of every light that casts a shadow: lit, shadowed, acne, leak against rays");
    command
        .add_option("--where", argument.where,
                    "Write condition: 1 where it holds, such as \"n_dot_l.0 < 0.5\"; with --buffers expression its "
                    "numbers, such as \"2 * n_dot_l.0\"")
        ->type_name("CONDITION");
    command
        .add_option("--mix", argument.mix,
                    "Write mix: the picture with other gains, such as ambient=0,specular.0=2; also =solo, =muted")
        ->type_name("TERM=GAIN,...");
}

}  // namespace app
