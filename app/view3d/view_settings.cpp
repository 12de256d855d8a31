#include "app/view3d/view_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "app/core/theme.h"

namespace app {

namespace {

// Lengths from 4 to 400 pixels by equal factors: the short ones need the finer steps.
constexpr double kShortest = 4, kFactor = 100;
constexpr int kSteps = 200;
int stepOf(double length) { return int(std::lround(kSteps * std::log(length / kShortest) / std::log(kFactor))); }
double lengthOf(int step) { return std::round(kShortest * std::pow(kFactor, double(step) / kSteps)); }
// Every 1st to every 100000th normal, in the same way.
int stepOfEvery(int every) { return int(std::lround(kSteps * std::log(every) / std::log(kSparsestNormals))); }
int everyOf(int step) { return int(std::lround(std::pow(kSparsestNormals, double(step) / kSteps))); }

}  // namespace

ViewSettings::ViewSettings(QWidget* parent) : QWidget(parent, Qt::Popup) {
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Settings of the 3D view"));
    auto* grid = new QGridLayout(this);
    const int padding = Theme::current().px(12);
    grid->setContentsMargins(padding, padding, padding, padding);
    grid->setHorizontalSpacing(padding);
    grid->setVerticalSpacing(Theme::current().px(8));
    m_normals = addChoice(tr("Normals"), tr("Which normals stand on the objects"),
                          {tr("Off"), tr("Polygon normals"), tr("Vertex normals")});
    m_normalLength = addSlider(tr("Length"), tr("Length of a normal's arrow, 4 to 400 pixels"), 0, kSteps);
    m_every = addSlider(tr("Every k-th"),
                        tr("Shows every k-th normal, 20 of each object at least and 10 000 of all at most"), 0, kSteps);
    m_normalColors = addChoice(tr("Their colour"), tr("All as N, or each by its direction: (N + 1) / 2 as RGB"),
                               {tr("As N"), tr("By direction, RGB")});
    m_vectorLength =
        addSlider(tr("Vectors"), tr("Length of N, L, V, R and H at the picked point, 4 to 400 pixels"), 0, kSteps);
    m_faces =
        addChoice(tr("Faces"), tr("Colours of the faces: the frame buffer's, or (N + 1) / 2 as red, green and blue"),
                  {tr("As shaded"), tr("Normals as RGB")});
    addHeading(tr("Around the scene"));
    addSwitch(tr("Bounding boxes"), tr("The smallest box along the axes around each object"), &ViewOptions::boxes);
    addSwitch(tr("Bounding spheres"), tr("A small sphere around each object"), &ViewOptions::spheres);
    addSwitch(tr("Frustum"), tr("What the scene's camera sees, from its near to its far plane"), &ViewOptions::frustum);
    addSwitch(tr("Light frusta"), tr("What each light sees, from its shadow buffer to the farthest polygon"),
              &ViewOptions::lightFrusta);
    addSwitch(tr("Handles"), tr("Lights, camera and objects can be dragged"), &ViewOptions::handles);
    m_objectTool = addChoice(tr("On an object"), {}, {tr("Move it"), tr("Turn it"), tr("Scale it")});
    addHeading(tr("At the picked point"));
    addSwitch(tr("Specular lobe"), tr("cosⁿ around R in Phong's model, around H in Blinn's"), &ViewOptions::lobe);
    addSwitch(tr("Projection of L on N"), tr("(N·L)N, and the rest of L at a right angle"), &ViewOptions::projection);
    addSwitch(tr("Law of reflection"), tr("R = 2(N·L)N − L as its construction"), &ViewOptions::reflection);
    setOptions({});
    setSpace(ViewSpace::World);
}

void ViewSettings::setSpace(ViewSpace space) {
    const bool flat = space == ViewSpace::Clip || space == ViewSpace::Screen, atPoint = space == ViewSpace::Point;
    const QString tip = tr("What the handle of an object changes (M)");
    m_objectTool->setEnabled(!flat && !atPoint);
    m_objectTool->setToolTip(flat      ? tr("Here lengths and angles mean nothing: an object can be moved only. ") + tip
                             : atPoint ? tr("Not at the point. ") + tip
                                       : tip);
}

QComboBox* ViewSettings::addChoice(const QString& name, const QString& tip, const QStringList& choices) {
    auto* grid = static_cast<QGridLayout*>(layout());
    const int row = grid->rowCount();
    auto* box = new QComboBox(this);
    box->addItems(choices);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    auto* label = new QLabel(name, this);
    label->setBuddy(box);
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1, 1, 2);
    connect(box, &QComboBox::currentIndexChanged, this, &ViewSettings::take);
    return box;
}

ViewSettings::Row ViewSettings::addSlider(const QString& name, const QString& tip, int low, int high) {
    auto* grid = static_cast<QGridLayout*>(layout());
    const int row = grid->rowCount();
    Row result{new QSlider(Qt::Horizontal, this), new QLabel(this)};
    result.slider->setRange(low, high);
    result.slider->setMinimumWidth(Theme::current().px(150));
    result.slider->setAccessibleName(name);
    result.slider->setToolTip(tip);
    result.value->setFont(Theme::current().mono(12));
    result.value->setMinimumWidth(Theme::current().px(56));
    result.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* label = new QLabel(name, this);
    label->setBuddy(result.slider);
    grid->addWidget(label, row, 0);
    grid->addWidget(result.slider, row, 1);
    grid->addWidget(result.value, row, 2);
    connect(result.slider, &QSlider::valueChanged, this, &ViewSettings::take);
    return result;
}

void ViewSettings::addHeading(const QString& words) {
    auto* grid = static_cast<QGridLayout*>(layout());
    auto* label = new QLabel(words, this);
    label->setProperty("tone", "3");
    label->setFont(Theme::current().text(12));
    grid->addWidget(label, grid->rowCount(), 0, 1, 3);
}

void ViewSettings::addSwitch(const QString& name, const QString& tip, bool ViewOptions::*shown) {
    auto* grid = static_cast<QGridLayout*>(layout());
    auto* box = new QCheckBox(name, this);
    box->setToolTip(tip);
    grid->addWidget(box, grid->rowCount(), 0, 1, 3);
    connect(box, &QCheckBox::toggled, this, &ViewSettings::take);
    m_switches.emplace_back(box, shown);
}

void ViewSettings::setOptions(const ViewOptions& options) {
    m_options = options;
    const QSignalBlocker a(m_normals), b(m_normalLength.slider), c(m_every.slider), d(m_vectorLength.slider),
        e(m_faces), f(m_normalColors), g(m_objectTool);
    m_normals->setCurrentIndex(int(options.normals));
    m_normalLength.slider->setValue(stepOf(options.normalLength));
    m_every.slider->setValue(stepOfEvery(options.everyNormal));
    m_vectorLength.slider->setValue(stepOf(options.vectorLength));
    m_faces->setCurrentIndex(int(options.faces));
    m_normalColors->setCurrentIndex(int(options.normalColors));
    m_objectTool->setCurrentIndex(int(options.objectTool));
    for (const auto& [box, shown] : m_switches) {
        const QSignalBlocker quiet(box);
        box->setChecked(options.*shown);
    }
    showValues();
}

void ViewSettings::take() {
    m_options.normals = static_cast<NormalsShown>(m_normals->currentIndex());
    m_options.normalLength = lengthOf(m_normalLength.slider->value());
    m_options.everyNormal = everyOf(m_every.slider->value());
    m_options.vectorLength = lengthOf(m_vectorLength.slider->value());
    m_options.faces = static_cast<FacesShown>(m_faces->currentIndex());
    m_options.normalColors = static_cast<NormalColors>(m_normalColors->currentIndex());
    m_options.objectTool = static_cast<HandleTool>(m_objectTool->currentIndex());
    for (const auto& [box, shown] : m_switches) m_options.*shown = box->isChecked();
    showValues();
    emit changed(m_options);
}

void ViewSettings::showValues() {
    m_normalLength.value->setText(tr("%1 px").arg(std::round(m_options.normalLength)));
    m_vectorLength.value->setText(tr("%1 px").arg(std::round(m_options.vectorLength)));
    m_every.value->setText(m_options.everyNormal == 1 ? tr("all") : tr("1 in %1").arg(m_options.everyNormal));
    const bool any = m_options.normals != NormalsShown::Off;
    m_normalLength.slider->setEnabled(any);
    m_every.slider->setEnabled(any);
    m_normalColors->setEnabled(any);
}

}  // namespace app
