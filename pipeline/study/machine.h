#pragma once
#include <string>

namespace pipeline {

// Where times were measured, for people: without it they say nothing.
std::string machineName();   // "AMD EPYC 7763, 2 processors"; "unknown processor, 2 processors"
std::string compilerName();  // "GCC 12.2.0, optimized"
double loadAverage();        // running programs over the last minute; below 0 where the system does not say

}  // namespace pipeline
