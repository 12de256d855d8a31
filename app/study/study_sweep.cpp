#include "app/study/study_sweep.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/core/text.h"

namespace app {

using pipeline::NamedSweep;
using pipeline::Sweep;

StudySweep::StudySweep(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    m_named = new QComboBox(this);
    m_named->setObjectName("studySweep");
    nameComboBox(*m_named, tr("Sweep"));
    m_meaning = styled(new QLabel(this), {.tone = 2, .size = 12, .wraps = true});
    m_state = styled(new QLabel(this), {.name = "studySweepState", .tone = 2, .size = 12, .wraps = true});
    m_own = new QWidget(this);
    auto* own = spaced(new QVBoxLayout(m_own), {});
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        auto* key = new QComboBox(m_own);
        auto* values = new QLineEdit(m_own);
        key->setObjectName(QString("studyKey%1").arg(i));
        nameComboBox(*key, i == 0 ? tr("First setting") : tr("Second setting"));
        values->setObjectName(QString("studyValues%1").arg(i));
        values->setAccessibleName(i == 0 ? tr("Values of the first setting") : tr("Values of the second setting"));
        values->setToolTip(tr("By comma, or a range: flat,phong · all · 4..7 · 0..1+0.25 · 4..64*2"));
        own->addWidget(key);
        own->addWidget(values);
        m_axes[i] = {key, values};
        connect(key, &QComboBox::activated, this, [this, key, values] {
            // Of a choice all; numbers are for the user to say.
            const auto refs = sweptSettings(m_document.scene(), key->currentData().toString().toStdString());
            const bool isChoice = refs && !refs->empty() && !refs->front().setting->choices.empty();
            values->setText(isChoice ? QString("all") : QString());
            showState();
        });
        connect(values, &QLineEdit::textChanged, this, &StudySweep::showState);
    }
    auto* column = spaced(new QVBoxLayout(this), {}, 6);
    for (QWidget* part : {static_cast<QWidget*>(m_meaning), m_own, static_cast<QWidget*>(m_state)})
        column->addWidget(part);
    connect(m_named, &QComboBox::currentIndexChanged, this, &StudySweep::showState);
    connect(m_named, &QComboBox::activated, this, [this](int at) {
        if (at == m_named->count() - 1) emit ownAsked();
    });
    connect(&document, &Document::sceneOpened, this, &StudySweep::fill);
    connect(&document, &Document::sceneChanged, this, &StudySweep::showState);
    fill();
}

// The sweeps and the settings that this scene has.
void StudySweep::fill() {
    if (!m_document.hasScene()) return;
    {
        const QSignalBlocker quiet(m_named);
        m_named->clear();
        auto* model = qobject_cast<QStandardItemModel*>(m_named->model());
        int first = -1;
        for (const NamedSweep& sweep : pipeline::namedSweeps()) {
            m_named->addItem(toQString(sweep.name), toQString(sweep.name));
            const int row = m_named->count() - 1;
            const bool fits = !sweep.sweeps(m_document.scene()).empty();
            model->item(row)->setEnabled(fits);
            model->item(row)->setToolTip(fits ? toQString(sweep.meaning) : tr("Needs %1.").arg(toQString(sweep.needs)));
            if (fits && first < 0) first = row;
        }
        m_named->addItem(tr("own settings"));
        m_named->setCurrentIndex(std::max(first, 0));
        QStringList keys;
        for (const pipeline::Setting& setting : pipeline::settingsTable())
            if (sweptSettings(m_document.scene(), setting.key)) keys << toQString(setting.key);
        for (AxisFields& axis : m_axes) {
            const QString before = axis.key->currentData().toString();
            axis.key->clear();
            axis.key->addItem(tr("no setting"), QString());
            for (const QString& key : keys) axis.key->addItem(key, key);
            axis.key->setCurrentIndex(std::max(0, axis.key->findData(before)));
        }
    }
    showState();
}

std::vector<std::string> StudySweep::texts() const {
    if (const QString name = m_named->currentData().toString(); !name.isEmpty()) return {name.toStdString()};
    std::vector<std::string> texts;
    for (const AxisFields& axis : m_axes)
        if (const QString key = axis.key->currentData().toString(); !key.isEmpty())
            texts.push_back((key + '=' + axis.values->text().simplified().remove(' ')).toStdString());
    return texts;
}

pipeline::Result<Sweep> StudySweep::sweep() const {
    if (!m_document.hasScene()) return pipeline::Error{{}, "there is no scene", "an open scene"};
    const std::vector<std::string> chosen = texts();
    if (chosen.empty()) return pipeline::Error{{}, "no setting is chosen", "one or two"};
    return pipeline::parseSweeps(m_document.scene(), chosen);
}

void StudySweep::setAxes(const QStringList& texts) {
    m_named->setCurrentIndex(m_named->count() - 1);
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const QStringList parts =
            qsizetype(i) < texts.size() ? texts[qsizetype(i)].split('=') : QStringList{QString(), QString()};
        QComboBox* key = m_axes[i].key;
        // One light's or object's own setting is not in the list: it would be long.
        if (key->findData(parts.value(0)) < 0) key->addItem(parts.value(0), parts.value(0));
        key->setCurrentIndex(key->findData(parts.value(0)));
        m_axes[i].values->setText(parts.value(1));
    }
    showState();
}

void StudySweep::showState() {
    const NamedSweep* named = pipeline::findNamedSweep(m_named->currentData().toString().toStdString());
    m_meaning->setText(named ? toQString(named->meaning) : QString());
    m_named->setToolTip(m_meaning->text());
    m_meaning->setVisible(named != nullptr);
    m_own->setVisible(!named);
    const auto found = sweep();
    if (found) {
        QStringList axes;
        for (const pipeline::SweepAxis& axis : found->axes) {
            QStringList values;
            for (const std::string& value : axis.values) values << toQString(value);
            axes << toQString(axis.label) + ": " + values.join(", ");
        }
        m_state->setText(axes.join('\n') + '\n' +
                         toQString(pipeline::plural(std::int64_t(pointCount(found->axes)), "point")));
    } else {
        m_state->setText(toQString(format(found.errors().front())));
    }
    emit changed();
}

}  // namespace app
