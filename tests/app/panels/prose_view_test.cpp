#include "app/lesson/prose_view.h"

#include <gtest/gtest.h>

namespace app {
namespace {

QString shown(const QString& markdown) {
    ProseView view;
    view.setProse(markdown);
    return view.toPlainText();
}

TEST(ProseView, GivesFormulasTheirScriptsAndLeavesCodeAsItIs) {
    EXPECT_EQ(shown("k_s and n^2").toStdString(), "ks and n2") << "raised and lowered, without their signs";
    EXPECT_EQ(shown("`GL_LIGHT0` and `a^b`").toStdString(), "GL_LIGHT0 and a^b");
    EXPECT_EQ(shown("```\nglEnable(GL_LIGHT0);\n```\n\nk_s").trimmed().toStdString(), "glEnable(GL_LIGHT0);\nks");
}

}  // namespace
}  // namespace app
