#pragma once
#include <map>

#include "pipeline/compare/verdict.h"

// Known errors measured in several places at once, such as the workers of a page: each takes some, one judges by all.

namespace pipeline::foreign {

// What errors leave, by their numbers among all that are tried.
using MeasuredErrors = std::map<std::size_t, Misfit>;

// Every error whose number leaves `part`, divided by `parts`. Nothing where it was stopped.
std::optional<MeasuredErrors> measureKnownErrors(const Report& report, std::size_t part, std::size_t parts);
// As nameKnownErrors(report); those that are given are not measured again.
bool nameKnownErrors(Report& report, const MeasuredErrors& given);

// Of hypotheses.cpp: the misfits of some errors, and findSuspects() with those that are known.
std::optional<MeasuredErrors> measureErrors(const Scene& scene, std::vector<KnownError> errors,
                                            const Reference& reference, const Conventions& conventions,
                                            const StatedConventions& stated, std::size_t part, std::size_t parts,
                                            const Stop& stop, const HypothesisProgress& progress);
Suspects findSuspects(const Scene& scene, std::vector<KnownError> errors, const Reference& reference,
                      const Conventions& conventions, const StatedConventions& stated,
                      const std::vector<Finding>& findings, const FirstWrong& first, const Stop& stop,
                      const HypothesisProgress& progress, const MeasuredErrors& given);

}  // namespace pipeline::foreign
