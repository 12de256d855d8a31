#pragma once
#include <string_view>

namespace pipeline::foreign {

// The style sheet of a report. Colours are those of the window's themes; on paper it is light.
inline constexpr std::string_view kReportStyle = R"(
:root { --bg: #F8F9FA; --raised: #FFF; --line: #D0D5DC; --text: #171A1F; --t2: #4A525D; --t3: #5E6672; --accent: #1B57BD;
        --tint: #DDE8FA; --run: #137244; --fail: #B3261E; --warn: #7A5200; }
@media screen and (prefers-color-scheme: dark) {
  :root { --bg: #1C1F24; --raised: #262A31; --line: #353A43; --text: #E9EBEE; --t2: #B4BBC6; --t3: #929AA6;
          --accent: #7FB2FF; --tint: #22304A; --run: #62D39B; --fail: #FF857C; --warn: #F3C14B; }
  b.vector.N { color: #8FDDFF; } b.vector.L { color: #FFD98C; } b.vector.V { color: #44A590; } b.vector.R { color: #F07426; }
  b.vector.H { color: #C6A5FF; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--bg); color: var(--text); font: 15px/1.55 Inter, "DejaVu Sans", system-ui, sans-serif; }
main { max-width: 1000px; margin: 0 auto; padding: 32px 32px 40px; }
h1 { font-size: 26px; line-height: 1.25; font-weight: 600; margin: 0 0 4px; display: flex; gap: 12px; }
h2 { font-size: 18px; font-weight: 600; margin: 32px 0 8px; }
p { margin: 6px 0; } .t2 { color: var(--t2); } .t3 { color: var(--t3); }
.run { color: var(--run); } .fail { color: var(--fail); font-weight: 600; } .warn { color: var(--warn); }
.mark { flex: none; width: 1.6em; text-align: center; font-weight: 600; }
code, .n { font-family: "JetBrains Mono", "DejaVu Sans Mono", ui-monospace, monospace; font-size: .93em; }
.n { text-align: right; } td.n { overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; }
th { font-weight: 500; color: var(--t3); text-align: left; font-size: 13px; border-bottom: 1px solid var(--line); padding: 4px 8px; }
td { padding: 7px 8px; border-bottom: 1px solid var(--line); vertical-align: top; }
tr.first td { background: var(--tint); }
.four { display: grid; grid-template-columns: repeat(2, 1fr); gap: 12px; }
figure { margin: 0; } figure img { width: 100%; display: block; image-rendering: pixelated; border: 1px solid var(--line); border-radius: 4px; }
figcaption { font-size: 13px; color: var(--t2); margin-top: 4px; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 16px; font-size: 13px; color: var(--t2); margin-top: 6px; }
.legend b { color: var(--text); font-weight: 500; } .legend .off { opacity: .6; }
.legend i { display: inline-block; width: 16px; height: 12px; border: 1px solid var(--line); margin-right: 5px; vertical-align: -1px; }
.formula { font-family: STIX, "STIX Two Math", "Latin Modern Math", serif; font-size: 18px; line-height: 1.75; overflow-x: auto; }
.formula b.vector { font-weight: 700; }
.differs { background: color-mix(in srgb, var(--fail) 14%, transparent); box-shadow: inset 0 -2px 0 var(--fail); border-radius: 3px; padding: 0 3px; }
.note { border-left: 4px solid var(--accent); padding: 2px 0 2px 12px; margin: 10px 0; }
details { border: 1px solid var(--line); border-radius: 6px; background: var(--raised); margin: 8px 0; }
summary { padding: 9px 14px; cursor: pointer; font-weight: 600; } summary span { font-weight: 400; color: var(--t2); }
details > div { padding: 0 14px 10px; }
pre { font: 13px/1.5 "JetBrains Mono", "DejaVu Sans Mono", ui-monospace, monospace; white-space: pre-wrap; overflow-wrap: anywhere;
      background: var(--raised); border: 1px solid var(--line); border-radius: 6px; padding: 10px 14px; margin: 6px 0; }
.wipe { position: relative; --w: 50%; max-width: 640px; margin-top: 12px; }
.wipe img { width: 100%; display: block; image-rendering: pixelated; border-radius: 4px; }
.wipe .top { position: absolute; inset: 0; clip-path: inset(0 calc(100% - var(--w)) 0 0); }
.slide { display: flex; align-items: center; gap: 12px; font-size: 13px; color: var(--t2); max-width: 640px; }
.slide input { flex: 1; accent-color: var(--accent); height: 24px; }
@media (max-width: 640px) {
  main { padding: 20px 16px 32px; } h1 { font-size: 21px; }
  .four figure.classes { grid-column: 1 / 3; order: -1; }
  .formula { font-size: 16px; }
  .stages thead { display: none; }
  .stages tr { display: grid; grid-template-columns: 26px 1fr auto; padding: 8px 0; border-bottom: 1px solid var(--line); }
  .stages tr.first { background: var(--tint); margin: 0 -8px; padding: 8px; }
  .stages td { border: 0; padding: 0; background: none !important; }
  .stages td:nth-child(4) { grid-column: 2 / 4; font-size: 14px; color: var(--t2); overflow-wrap: anywhere; } .stages td:nth-child(5) { display: none; }
  .small td, .small th { padding: 5px 4px; font-size: 13px; } }
@media print { body { background: #fff; font-size: 10.5pt; } main { max-width: none; padding: 0; }
  figure, table, details, .formula { break-inside: avoid; } h2 { break-after: avoid; } .wipebox { display: none; } }
)";

}  // namespace pipeline::foreign
