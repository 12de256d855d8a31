#include "tests/bench/gl_scene.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <span>

#include "pipeline/run/frame_data.h"

namespace bench {
namespace {

using namespace pipeline;
using Matrix = std::array<float, 16>;  // column by column

// World to clip coordinates, from what a view says of the screen: x_ndc = (s_x / c_x) x / z, likewise y, and z_ndc from
// -1 at the near plane to 1 at the far plane.
Matrix clipFromWorld(const View& view) {
    const double n = view.near, f = view.far;
    const Vec3d rows[3]{view.scale.x / view.centre.x * view.right, view.scale.y / view.centre.y * view.up,
                        view.forward};
    const auto column = [&](int c) {
        const double z = rows[2][c], depth = view.perspective ? (f + n) / (f - n) * z : 2 / (f - n) * z;
        return std::array{rows[0][c], rows[1][c], depth, view.perspective ? z : 0.0};
    };
    Matrix m{};
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 4; ++r) m[std::size_t(4 * c + r)] = float(column(c)[std::size_t(r)]);
    const Vec3d origin = toView(view, Vec3d(0));  // of the world
    const double depth = origin.z;
    m[12] = float(view.scale.x / view.centre.x * origin.x), m[13] = float(view.scale.y / view.centre.y * origin.y);
    m[14] = float(view.perspective ? ((f + n) * depth - 2 * f * n) / (f - n) : (2 * depth - f - n) / (f - n));
    m[15] = view.perspective ? float(depth) : 1;
    return m;
}

constexpr const char* kPlaceOnly = R"(#version 330
layout(location = 0) in vec3 place;
uniform mat4 clipFromWorld;
void main() { gl_Position = clipFromWorld * vec4(place, 1); }
)";
constexpr const char* kNothing = "#version 330\nvoid main() {}\n";
constexpr const char* kPlaceAndNormal = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
uniform mat4 clipFromWorld, lightFromWorld;
out vec3 surface, direction;
out vec4 fromLight;
void main() {
    gl_Position = clipFromWorld * vec4(place, 1);
    surface = place;
    direction = normal;
#ifdef SHADOWED
    fromLight = lightFromWorld * vec4(place, 1);
#endif
}
)";
// Lecture 1's model, its intensities divided by the one that 255 stands for.
constexpr const char* kPhong = R"(
in vec3 surface, direction;
in vec4 fromLight;
uniform vec3 eye, towardsLight, ambient, diffuse, specular;
uniform float exponent, bias;
uniform sampler2D shadowBuffer;
out vec4 color;
void main() {
    vec3 N = normalize(direction), V = normalize(eye - surface);
    float nDotL = dot(N, towardsLight);
    vec3 intensity = ambient;
    if (nDotL > 0) {
        float rDotV = dot(2 * nDotL * N - towardsLight, V);
        vec3 lit = nDotL * diffuse + (rDotV > 0 ? pow(rDotV, exponent) : 0) * specular;
#ifdef SHADOWED
        vec3 at = fromLight.xyz * 0.5 + 0.5;
        if (at.z > texture(shadowBuffer, at.xy).r + bias) lit = vec3(0);
#endif
        intensity += lit;
    }
    color = vec4(intensity, 1);
}
)";

// Fills the buffer bound to `target` for good.
template <class T>
void upload(GLenum target, const std::vector<T>& values) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

// Everything lives as long as the process that measures: a child that ends with its figures.
class Drawn final : public GlScene {
public:
    Drawn(const FrameData<float>& data, const Scene& scene, Geometry geometry, std::string& whyNot)
        : m_geometry(geometry), m_size(data.transform->view.size), m_shaded(data.shading != nullptr) {
        const Topology& topology = *data.transform->topology;
        m_corners = GLsizei(topology.triangles.size() * 3);
        if (data.shadowBuffer && !data.shadowBuffer->lights[0].empty()) {
            m_shadowSize = data.keys.shadowBuffer.size;
            m_lightView = clipFromWorld(data.shadowBuffer->lights[0][0].faces[0]);
        }
        m_view = clipFromWorld(data.transform->view);
        m_placeArray = arrayOf(topology, {data.transform->world});
        m_placeProgram = program(kPlaceOnly, kNothing, whyNot);
        if (m_shadowSize > 0) m_shadow = target({m_shadowSize, m_shadowSize}, false);
        m_picture = target(m_size, m_shaded);
        if (m_shaded) {
            const std::string head = m_shadowSize > 0 ? "#version 330\n#define SHADOWED\n" : "#version 330\n";
            m_litArray = arrayOf(topology, {data.transform->world, data.normals->vertex});
            m_litProgram = program(head + kPlaceAndNormal, head + kPhong, whyNot);
            setLight(data, scene);
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) whyNot = "no complete framebuffer";
        if (const GLenum code = glGetError(); code != GL_NO_ERROR) whyNot = fmt::format("OpenGL error {:#x}", code);
    }

    void draw() override {
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        if (m_shadowSize > 0) {
            begin(m_shadow, {m_shadowSize, m_shadowSize}, false);
            drawPlaces(m_lightView);
        }
        begin(m_picture, m_size, m_shaded);
        if (m_shaded) {
            glUseProgram(m_litProgram);
            glBindTexture(GL_TEXTURE_2D, m_shadow.depth);
            drawArray(m_litArray);
        } else {
            drawPlaces(m_view);
        }
        glFinish();
    }

    std::vector<Color8> color() override {
        const auto rgba = read<std::array<GLubyte, 4>>(GL_RGBA, GL_UNSIGNED_BYTE);
        std::vector<Color8> out;
        for (const auto& p : rgba) out.emplace_back(p[0], p[1], p[2]);
        return out;
    }
    std::vector<float> depth() override { return read<float>(GL_DEPTH_COMPONENT, GL_FLOAT); }

private:
    struct Target {
        GLuint framebuffer = 0, depth = 0;
    };

    static GLuint texture(GLenum format, glm::ivec2 size) {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexStorage2D(GL_TEXTURE_2D, 1, format, size.x, size.y);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        return name;
    }
    static Target target(glm::ivec2 size, bool colored) {
        Target out;
        glGenFramebuffers(1, &out.framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, out.framebuffer);
        out.depth = texture(GL_DEPTH_COMPONENT32F, size);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, out.depth, 0);
        if (colored)
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture(GL_RGBA8, size), 0);
        else
            glDrawBuffer(GL_NONE), glReadBuffer(GL_NONE);
        return out;
    }

    // The vertices' values side by side, as the chosen geometry has them.
    GLuint arrayOf(const Topology& topology, std::initializer_list<std::span<const glm::vec3>> values) const {
        std::vector<glm::vec3> all;
        std::vector<std::uint32_t> indices;
        const auto put = [&](std::size_t vertex) {
            for (const auto& value : values) all.push_back(value[vertex]);
        };
        if (m_geometry == Geometry::Indexed)
            for (std::size_t i = 0; i < topology.vertexCount(); ++i) put(i);
        for (const Triangle& triangle : topology.triangles)
            for (const std::uint32_t vertex : triangle.vertices)
                m_geometry == Geometry::Indexed ? indices.push_back(vertex) : put(vertex);
        GLuint array = 0;
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
        upload(GL_ARRAY_BUFFER, all);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t offset = i * sizeof(glm::vec3);
            glEnableVertexAttribArray(GLuint(i));
            glVertexAttribPointer(GLuint(i), 3, GL_FLOAT, GL_FALSE, GLsizei(values.size() * sizeof(glm::vec3)),
                                  reinterpret_cast<const void*>(offset));
        }
        if (!indices.empty()) upload(GL_ELEMENT_ARRAY_BUFFER, indices);
        return array;
    }

    static GLuint program(const std::string& vertex, const std::string& fragment, std::string& whyNot) {
        const GLuint made = glCreateProgram();
        for (const auto& [kind, text] : {std::pair(GL_VERTEX_SHADER, &vertex), {GL_FRAGMENT_SHADER, &fragment}}) {
            const GLuint shader = glCreateShader(GLenum(kind));
            const char* source = text->c_str();
            glShaderSource(shader, 1, &source, nullptr);
            glCompileShader(shader);
            glAttachShader(made, shader);
        }
        glLinkProgram(made);
        GLint linked = 0;
        glGetProgramiv(made, GL_LINK_STATUS, &linked);
        if (!linked) {
            std::array<char, 2000> log{};
            glGetProgramInfoLog(made, GLsizei(log.size()), nullptr, log.data());
            whyNot = std::string("a shader does not link: ") + log.data();
        }
        return made;
    }

    void setLight(const FrameData<float>& data, const Scene& scene) {
        const ShadingInputs& inputs = data.keys.shading;
        const Material& material = inputs.materials[0];
        const Light& light = scene.lights[0];
        const Vec3d shining = light.intensity * light.color / data.shading->iMax;
        glUseProgram(m_litProgram);
        const auto vector = [&](const char* name, Vec3d v) {
            glUniform3f(glGetUniformLocation(m_litProgram, name), float(v.x), float(v.y), float(v.z));
        };
        vector("eye", data.transform->view.eye);
        vector("towardsLight", glm::normalize(light.position));
        vector("ambient", inputs.ambient.lightIn(inputs.illumination.model) * material.diffuse / data.shading->iMax);
        vector("diffuse", shining * material.diffuse);
        vector("specular", shining * material.specular);
        glUniform1f(glGetUniformLocation(m_litProgram, "exponent"), float(material.exponent));
        // Of the depth between near and far, which stand three times as far apart as the scene is deep.
        glUniform1f(glGetUniformLocation(m_litProgram, "bias"), 0.002F);
        setMatrix(m_litProgram, "clipFromWorld", m_view);
        if (m_shadowSize == 0) return;
        setMatrix(m_litProgram, "lightFromWorld", m_lightView);
        glUniform1i(glGetUniformLocation(m_litProgram, "shadowBuffer"), 0);
    }
    static void setMatrix(GLuint program, const char* name, const Matrix& matrix) {
        glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, matrix.data());
    }

    static void begin(const Target& target, glm::ivec2 size, bool colored) {
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        glViewport(0, 0, size.x, size.y);
        glClear(GL_DEPTH_BUFFER_BIT | (colored ? GLbitfield(GL_COLOR_BUFFER_BIT) : 0));
    }
    void drawPlaces(const Matrix& view) const {
        glUseProgram(m_placeProgram);
        setMatrix(m_placeProgram, "clipFromWorld", view);
        drawArray(m_placeArray);
    }
    void drawArray(GLuint array) const {
        glBindVertexArray(array);
        if (m_geometry == Geometry::Indexed)
            glDrawElements(GL_TRIANGLES, m_corners, GL_UNSIGNED_INT, nullptr);
        else
            glDrawArrays(GL_TRIANGLES, 0, m_corners);
    }
    template <class T>
    std::vector<T> read(GLenum what, GLenum type) const {
        const auto width = std::size_t(m_size.x), height = std::size_t(m_size.y);
        std::vector<T> upward(width * height), out;
        glBindFramebuffer(GL_FRAMEBUFFER, m_picture.framebuffer);
        glReadPixels(0, 0, m_size.x, m_size.y, what, type, upward.data());
        for (std::size_t y = height; y-- > 0;)
            out.insert(out.end(), upward.begin() + std::ptrdiff_t(y * width),
                       upward.begin() + std::ptrdiff_t((y + 1) * width));
        return out;
    }

    Geometry m_geometry;
    glm::ivec2 m_size;
    bool m_shaded;
    int m_shadowSize = 0;  // texels; 0: no shadow buffer
    GLsizei m_corners = 0;
    Matrix m_view{}, m_lightView{};
    GLuint m_placeArray = 0, m_litArray = 0, m_placeProgram = 0, m_litProgram = 0;
    Target m_shadow, m_picture;
};

}  // namespace

std::unique_ptr<GlScene> GlScene::make(const Frame& frame, Geometry geometry, std::string& whyNot) {
    const FrameData<float>* data = dataOf<float>(frame);
    if (!data) {
        whyNot = "the frame is not in float";
        return nullptr;
    }
    auto made = std::make_unique<Drawn>(*data, frame.scene(), geometry, whyNot);
    if (!whyNot.empty()) return nullptr;
    return made;
}

}  // namespace bench
