#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "pipeline/study/sweep.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace app {

// What a study is to go through: a ready-made sweep, or one or two settings with their values, as
// --sweep takes them.
class StudySweep : public QWidget {
    Q_OBJECT
public:
    explicit StudySweep(Document& document, QWidget* parent = nullptr);

    QComboBox& names() { return *m_named; }  // ready-made sweeps, and own settings: stands where the owner wants it
    // The sweep of the document's scene; the errors stand beneath the fields too.
    pipeline::Result<pipeline::Sweep> sweep() const;
    void setAxes(const QStringList& texts);  // own settings: "shading=flat,phong"; at most two

signals:
    void changed();
    void ownAsked();  // by the user: fields that are here

private:
    struct AxisFields {
        QComboBox* key;
        QLineEdit* values;
    };
    std::vector<std::string> texts() const;
    void fill();
    void showState();

    Document& m_document;
    QComboBox* m_named;
    QLabel *m_meaning, *m_state;
    QWidget* m_own;
    std::array<AxisFields, 2> m_axes{};
};

}  // namespace app
