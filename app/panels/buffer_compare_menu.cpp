// What a BufferCompare offers and says; what it does stands in buffer_compare.cpp.
#include <QFileDialog>
#include <QMenu>
#include <algorithm>

#include "app/core/derived_buffers.h"
#include "app/core/numbers.h"
#include "app/core/renderer_check.h"
#include "app/core/text.h"
#include "app/panels/buffer_compare.h"
#include "lessons/state/state_text.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferName;
using pipeline::Domain;

namespace {

QString placeText(const AnyBuffer& buffer, std::size_t element) {
    if (standsOnShapes(*buffer.info)) return QString::number(element);
    return QString("%1, %2").arg(element % buffer.columns()).arg(element / buffer.columns());
}

}  // namespace

QString findingText(const pipeline::BufferDifference& found) {
    static const QStringList things{"vertices", "polygons", "pixels", "texels"};
    const AnyBuffer& values = found.values;
    const QString thing = things[int(values.info->domain)];
    if (found.differing == 0) return QString("All %1 are the same.").arg(thing);
    const auto all = qint64(found.compared + found.oneSided);
    QString text = QString("%1 of %2 %3 differ").arg(count(qint64(found.differing)), count(all), thing);
    if (found.largest > 0)
        text += QString(", most by %1 at %2").arg(valueText(values, found.largest), placeText(values, *found.worst));
    if (found.oneSided > 0) text += QString(", %1 have a value on one side only").arg(count(qint64(found.oneSided)));
    return text;
}

void BufferCompare::fillMenu(QMenu& menu, const BufferName& shown) {
    menu.clear();
    menu.setToolTipsVisible(true);
    if (!m_document.frames().shown()) return;
    QHash<QString, QMenu*> menus;
    const auto menuOf = [&](const QString& path) {
        QMenu* place = &menu;
        QString whole;
        for (const QString& part : path.split('/', Qt::SkipEmptyParts)) {
            whole += '/' + part;
            QMenu*& sub = menus[whole];
            if (!sub) {
                sub = place->addMenu(part);
                sub->setToolTipsVisible(true);
            }
            place = sub;
        }
        return place;
    };
    for (const OtherChoice& choice :
         otherChoices(*m_document.frames().shown(), shown, bool(m_document.history().sceneBefore()),
                      m_document.derived().recipe())) {
        QAction* action = menuOf(choice.group)->addAction(choice.text, this, [this, source = choice.source] {
            compareWith(source);
            emit chosen();
        });
        action->setCheckable(true);
        action->setChecked(m_source == choice.source);
        action->setEnabled(choice.whyNot.isEmpty());
        action->setToolTip(choice.whyNot);
    }
    QAction* mine = menu.addAction(tr("My renderer"), this, [this] {
        compareWith(OtherSource{.kind = OtherSource::Kind::Mine});
        emit chosen();
    });
    mine->setCheckable(true);
    mine->setChecked(isMine());
    mine->setEnabled(m_document.renderer().isOpen());
    if (!mine->isEnabled()) mine->setToolTip(m_document.renderer().whyNo(shown));
    menu.addAction(tr("A file…"), this, &BufferCompare::chooseFile);
    menu.addSeparator();
    QAction* nothing = menu.addAction(tr("Nothing"), this, [this] { compareWith(std::nullopt); });
    nothing->setEnabled(m_source.has_value());
    if (!m_source) nothing->setToolTip(tr("Nothing is compared."));
}

std::optional<lessons::BufferShown::Compared> BufferCompare::state() const {
    if (!m_source || m_source->kind == OtherSource::Kind::Mine) return {};
    OtherSource source = *m_source;
    const auto change = m_document.history().lastChange();
    if (source.kind == OtherSource::Kind::Before && change)
        source = {.kind = OtherSource::Kind::Setting, .setting = change->setting, .value = change->before};
    lessons::BufferShown::Compared state{keyOf(source), std::string(lessons::kCompareModes[std::size_t(m_mode)]),
                                         m_share, std::string(pipeline::metricTable()[std::size_t(m_metric)].name)};
    if (m_range) state.range = {m_range->first, m_range->last};
    return state;
}

pipeline::Errors BufferCompare::lookAt(const std::optional<lessons::BufferShown::Compared>& state) {
    if (!state || !m_document.hasScene()) {
        compareWith(std::nullopt);
        return {};
    }
    const auto source = sourceNamed(state->with, m_document.scene());
    if (!source) {
        compareWith(std::nullopt);
        return source.errors();
    }
    for (const pipeline::MetricInfo& metric : pipeline::metricTable())
        if (metric.name == state->metric) m_metric = metric.id;
    m_share = state->wipe;
    compareWith(*source);
    if (state->range && (*state->range)[0] != (*state->range)[1])
        m_range = pipeline::PaletteRange{(*state->range)[0], (*state->range)[1]};
    const auto mode = std::ranges::find(lessons::kCompareModes, state->mode);
    const auto wanted =
        mode == lessons::kCompareModes.end() ? CompareMode::Wipe : CompareMode(mode - lessons::kCompareModes.begin());
    m_mode = CompareMode::A;
    setMode(wanted);
    return {};
}

void BufferCompare::goToWorst() {
    m_goesToWorst = !m_found;
    if (!m_found || !m_found->worst) return;
    const std::size_t worst = *m_found->worst;
    const auto columns = m_found->values.columns();
    switch (m_found->values.info->domain) {
        case Domain::Pixel: return m_document.pointing().pick(glm::ivec2(worst % columns, worst / columns));
        case Domain::Polygon:
            return m_document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, worst});
        case Domain::Vertex:
            return m_document.pointing().select(lessons::Selection{lessons::Selection::Kind::Vertex, worst});
        case Domain::Texel: break;
    }
}

void BufferCompare::chooseFile() {
    const QString file = QFileDialog::getOpenFileName(m_bar->window(), tr("Compare with a file"), QString(),
                                                      tr("Pictures and arrays (*.png *.npy *.exr);;All files (*)"));
    if (!file.isEmpty()) compareWith(OtherSource{.kind = OtherSource::Kind::File, .file = file});
}

}  // namespace app
