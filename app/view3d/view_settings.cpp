#include "app/view3d/view_settings.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "app/look/accessible.h"
#include "app/look/theme.h"

namespace app {

namespace {

constexpr double kShortest = 4, kLongest = 400;  // arrows, pixels
constexpr int kSteps = 200;

}  // namespace

// From a low number to a high one by equal factors: the small ones need the finer steps. A screen reader is told the
// number, not the step.
class FactorSlider : public QSlider, public AccessibleSlider {
public:
    FactorSlider(double low, double high, QWidget* parent)
        : QSlider(Qt::Horizontal, parent), m_low(low), m_high(high), m_number(low) {
        speak(*this);
        setRange(0, kSteps);
    }
    double number() const { return m_number; }
    void setNumber(double number) {
        slideTo(number);
        m_number = number;  // it may stand between two steps
    }
    Scale spoken() const override { return {m_number, m_low, m_high, 1}; }
    void slideTo(double number) override {
        setValue(int(std::lround(kSteps * std::log(number / m_low) / std::log(m_high / m_low))));
    }

protected:
    void sliderChange(SliderChange change) override {
        QSlider::sliderChange(change);
        if (change != SliderValueChange) return;
        m_number = std::round(m_low * std::pow(m_high / m_low, double(value()) / kSteps));
        sayValue(*this);
    }

private:
    double m_low, m_high, m_number;
};

ViewSettings::ViewSettings(QWidget* parent) : QWidget(parent, Qt::Popup) {
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Settings of the 3D view"));
    new QGridLayout(this);
    m_normals = addChoice(tr("Normals"), tr("Which normals stand on the objects"),
                          {tr("Off"), tr("Polygon normals"), tr("Vertex normals")});
    m_normalLength = addSlider(tr("Length"), tr("Length of a normal's arrow, 4 to 400 pixels"), kShortest, kLongest);
    m_every =
        addSlider(tr("Show every k-th normal"),
                  tr("Show every k-th normal: at least 20 of each object, at most 10 000 in all"), 1, kSparsestNormals);
    m_normalColors = addChoice(tr("Their colour"), tr("All as N, or each by its direction: (N + 1) / 2 as RGB"),
                               {tr("As N"), tr("By direction, RGB")});
    m_vectorLength = addSlider(tr("Vectors"), tr("Length of N, L, V, R and H at the picked point, 4 to 400 pixels"),
                               kShortest, kLongest);
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
    connect(&Theme::current(), &Theme::changed, this, &ViewSettings::applyTheme);
    applyTheme();
}

void ViewSettings::applyTheme() {
    const Theme& theme = Theme::current();
    auto* grid = static_cast<QGridLayout*>(layout());
    const int padding = theme.px(12);
    grid->setContentsMargins(padding, padding, padding, padding);
    grid->setHorizontalSpacing(padding);
    grid->setVerticalSpacing(theme.px(8));
    for (const Row& row : {m_normalLength, m_every, m_vectorLength}) {
        row.slider->setMinimumSize(theme.px(150), theme.px(16));  // its handle has to fit
        row.value->setFont(theme.mono(12));
        row.value->setMinimumWidth(theme.px(56));
    }
    for (QLabel* heading : m_headings) heading->setFont(theme.text(12));
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

ViewSettings::Row ViewSettings::addSlider(const QString& name, const QString& tip, double low, double high) {
    auto* grid = static_cast<QGridLayout*>(layout());
    const int row = grid->rowCount();
    Row result{new FactorSlider(low, high, this), new QLabel(this)};
    result.slider->setAccessibleName(name);
    result.slider->setToolTip(tip);
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
    grid->addWidget(label, grid->rowCount(), 0, 1, 3);
    m_headings.push_back(label);
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
    m_normalLength.slider->setNumber(options.normalLength);
    m_every.slider->setNumber(options.everyNormal);
    m_vectorLength.slider->setNumber(options.vectorLength);
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
    m_options.normalLength = m_normalLength.slider->number();
    m_options.everyNormal = int(m_every.slider->number());
    m_options.vectorLength = m_vectorLength.slider->number();
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
