#pragma once
#include "tests/architecture/source_tree.h"

// The rules of CONTRIBUTING.md that can be read off the sources.
namespace architecture {

// One line a breach, "FILE:LINE: what is there; the rule". Empty where the rule is kept.
using Breaches = std::vector<std::string>;

// A project's own header is included by its path from the root, and is there.
Breaches unrootedIncludes(const SourceTree& tree);
// Arrows point one way: app -> lessons -> lessons/state -> pipeline_io -> pipeline. A room of the window includes only
// rooms above it in the table. app/cli is built without Qt and includes none of these.
// Nothing but tests includes tests.
Breaches includesPointingBack(const SourceTree& tree);
// No feature of the window includes the panel of another: a header that app/docks/panel_table.cpp includes.
Breaches panelsIncludingPanels(const SourceTree& tree);
// Qt only in app, and not in app/cli; VTK only in app/vtk.
Breaches misplacedToolkits(const SourceTree& tree);
// The pipeline does not print. Its stages know no threads, plan or runner.
Breaches impurePipeline(const SourceTree& tree);
// app/cli/message.cpp alone prints: it escapes what no terminal should get.
Breaches printingPastMessages(const SourceTree& tree);
// Texts come from files. Markup is read only where a file of this list builds it and escapes what it puts in.
Breaches markupInNewPlaces(const SourceTree& tree);
// Numbers are written by {fmt} and read by from_chars or Qt, which know no locale: in many of them a comma stands where
// files and texts have a point.
Breaches numbersOfALocale(const SourceTree& tree);
// What frames are made of calls no elementary function of a library, whose last bits differ from machine to machine, but
// those of pipeline/core/elementary.h. Extended and quad precision keep the library's.
Breaches functionsOfALibrary(const SourceTree& tree);
// No two random numbers among the arguments of one call: C++ leaves their order open, so that every compiler would draw
// another scene. In braces they are drawn from left to right.
Breaches unorderedDraws(const SourceTree& tree);
// At most 400 lines a file, 200 a stage's .cpp.
Breaches longFiles(const SourceTree& tree);
// Every .cpp is named in the CMakeLists.txt of its folder or of one above.
Breaches unlistedSources(const SourceTree& tree);
// No path of one person's machine.
Breaches machinePaths(const SourceTree& tree);
// README.md, CONTRIBUTING.md and the pages of the manual, without tables and code: at most 25 words a sentence.
Breaches longSentences(const SourceTree& tree);
// The same pages, with tables: no word that has a better one. Code and labels of the window, *in italics*, do not count.
Breaches replacedWords(const SourceTree& tree);
// At the root only what the layout in CONTRIBUTING.md names.
Breaches strangersAtTheTop(const std::vector<std::string>& names);

}  // namespace architecture
