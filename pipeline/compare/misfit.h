#pragma once
#include "pipeline/compare/finding.h"
#include "pipeline/compare/handed_in/picture_sample.h"

namespace pipeline::foreign {

// How rows and columns of a folder's pictures run: one choice for all of them.
struct Geometry {
    bool bottomUp = false, mirrored = false;
    bool operator==(const Geometry&) const = default;
};

// What a frame leaves unexplained of the files, read in the way that suits it best.
struct Misfit {
    Geometry geometry;
    std::vector<Reading> readings;  // per file
    // Per file: the elements that are wrong by the verdict's own rules. Of a table its share of them, times the pixels
    // drawn, so that all files count alike.
    std::vector<double> wrong;
    std::size_t drawn = 0;  // pixels, by the frame
    double sum(const std::vector<std::size_t>& files) const {
        double all = 0;
        for (const std::size_t i : files) all += wrong[i];
        return all;
    }
};

// The files of a folder with all readings that are still possible: which of them is meant is asked of each frame anew, as
// a reading that was chosen for the right frame need not be the one under which a wrong frame explains the files.
class FolderEvidence {
public:
    // factor: a picture of blocks of factor × factor pixels, for ranking. With 1 the files of `conventions` are read in
    // place: they have to outlive this.
    FolderEvidence(const Conventions& conventions, const StatedConventions& stated, const Reference& right,
                   std::size_t factor);
    Misfit misfit(const Reference& hypothesis) const;
    BufferSet compared() const;

private:
    struct Testimony {
        std::shared_ptr<const HandedFile> file;  // the folder's own, or a smaller picture made of it
        HandedFile sample;                       // some of its pixels
        std::vector<Reading> readings;
        bool isPicture = false, counts = true;
        double tolerance = 0;
        std::size_t elements = 0;
    };
    double sampledWrong(const Testimony& one, const Reading& reading, const Values& right,
                        const std::vector<std::uint8_t>& covered) const;
    Reading bestOnSample(const Testimony& one, const Geometry& geometry, const Values& right,
                         const std::vector<std::uint8_t>& covered, double& least) const;
    void forgetLarge(const Testimony& one, const Reference& hypothesis) const;
    double wrongIn(const Testimony& one, const Reading& reading, const Reference& hypothesis) const;

    std::size_t m_factor;
    ReadingContext m_context, m_sampleContext;
    std::vector<Geometry> m_geometries;
    PictureSample m_sample;
    double m_drawn = 1;  // pixels, by the right frame
    std::vector<Testimony> m_files;
};

}  // namespace pipeline::foreign
