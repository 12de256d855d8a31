#pragma once
#include <string_view>

namespace pipeline {

// The style sheet of a study's page. Colours are those of the window's themes; on paper it is light.
inline constexpr std::string_view kStudyStyle = R"(
:root { --bg: #FFFFFF; --text: #171A1F; --text2: #4A525D; --line: #D0D5DC; --accent: #1B57BD; --run: #137244;
        --failed: #B3261E; --track: #E3E8EE; }
@media screen and (prefers-color-scheme: dark) {
  :root { --bg: #101215; --text: #E9EBEE; --text2: #B4BBC6; --line: #353A43; --accent: #7FB2FF; --run: #62D39B;
          --failed: #FF857C; --track: #31363F; } }
body { margin: 0; background: var(--bg); color: var(--text); font: 16px/1.5 Inter, system-ui, sans-serif; }
main { max-width: 64rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; }
h4 { margin: 1.5rem 0 .25rem; }
p { max-width: 46rem; margin: .5rem 0; }
p.answer { font-size: 1.1rem; }
figure { margin: 1.5rem 0; }
img { max-width: 100%; height: auto; display: block; }
figcaption { color: var(--text2); font-size: .875rem; padding-top: .25rem; }
table { border-collapse: collapse; margin: .5rem 0; min-width: 50%; }
th, td { text-align: left; padding: .25rem 1rem .25rem 0; border-bottom: 1px solid var(--line); vertical-align: baseline; }
th { color: var(--text2); font-weight: 500; font-size: .875rem; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
td.n, .code { font-family: "JetBrains Mono", ui-monospace, monospace; font-size: .9em; }
td.front { color: var(--run); }
tr.failed, p.failed { color: var(--failed); }
details { border-top: 1px solid var(--line); padding: .5rem 0; }
summary { cursor: pointer; font-weight: 600; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
.pictures figure { flex: 1 1 14rem; margin: .5rem 0; }
.pictures img { width: 100%; image-rendering: pixelated; }
table.bars { width: 100%; max-width: 40rem; }
td.bar { width: 60%; }
td.bar span { display: block; height: .6rem; background: var(--accent); min-width: 1px; }
@media print { main { max-width: none; padding: 0; } table, figure, p { break-inside: avoid; } }
)";

}  // namespace pipeline
