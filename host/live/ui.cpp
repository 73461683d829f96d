#include "live/ui.h"

#include "live/overlay_compare.h"
#include "live/overlays.h"
#include "live/panel.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace dioptre
{
namespace
{

constexpr float fontSize_px = 15.0F;

// What titles, names and drivers' messages are likely to hold.
constexpr std::array<ImWchar, 17> letters{0x0020, 0x024F, // Latin
                                          0x0370, 0x052F, // Greek, Cyrillic
                                          0x2010, 0x2044, // punctuation
                                          0x2070, 0x209F, // raised and lowered
                                          0x20A0, 0x20BF, // money
                                          0x2190, 0x22FF, // arrows, mathematics
                                          0x25A0, 0x25FF, // shapes
                                          0xFFFD, 0xFFFD, 0};

// A font of the system's, or the one that Dear ImGui brings.
ImFont* fontFrom(const std::filesystem::path& file, float scale)
{
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error))
        if (ImFont* font =
                fonts.AddFontFromFileTTF(file.c_str(), scale * fontSize_px, nullptr, letters.data()))
            return font;
    ImFontConfig own;
    own.SizePixels = std::max(13.0F, scale * 13.0F);
    return fonts.AddFontDefault(&own);
}

void styleAs(float scale)
{
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {8.0F, 6.0F};
    style.FramePadding = {4.0F, 2.0F};
    style.ItemSpacing = {6.0F, 3.0F};
    style.ItemInnerSpacing = {4.0F, 3.0F};
    style.IndentSpacing = 12.0F;
    style.ScrollbarSize = 11.0F;
    style.WindowRounding = 4.0F;
    style.FrameRounding = 2.0F;
    style.GrabRounding = 2.0F;
    style.Colors[ImGuiCol_PlotHistogram] = {0.25F, 0.45F, 0.7F, 1.0F};
    style.ScaleAllSizes(scale);
}

} // namespace

Ui::Ui(const Window& window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // what is remembered is remembered for each input, elsewhere
    float scale = 1.0F;                   // of a screen with small pixels
    glfwGetWindowContentScale(window.handle(), &scale, nullptr);
    styleAs(scale);
    const std::filesystem::path fonts = "/usr/share/fonts/truetype/dejavu";
    fontFrom(fonts / "DejaVuSans.ttf", scale);
    code_ = fontFrom(fonts / "DejaVuSansMono.ttf", scale);
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Ui::~Ui()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

UiWishes Ui::draw(const LiveModel& model, const UiFacts& facts)
{
    UiWishes wishes;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const float bottom_px = ImGui::GetIO().DisplaySize.y - (model.fault ? faultHeight_px() + 8.0F : 0.0F);
    float left_px = 0.0F;
    if (model.showPanel)
        left_px = drawPanel(model, facts, bottom_px, panel_, wishes);
    if (facts.stage.loaded() != nullptr && facts.stage.loaded()->scene)
        drawComparison(model.methods, facts.dividerHeld, left_px);
    if (model.fault) {
        if (facts.stage.loaded() != nullptr)
            drawStaleMark(left_px);
        drawFault(*model.fault, code_);
    }
    if (model.showHelp)
        drawHelp();
    if (!model.notice.empty())
        drawNotice(model.notice, left_px);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return wishes;
}

bool Ui::wantsPointer() const
{
    return ImGui::GetIO().WantCaptureMouse;
}

bool Ui::wantsKeys() const
{
    return ImGui::GetIO().WantTextInput;
}

} // namespace dioptre
