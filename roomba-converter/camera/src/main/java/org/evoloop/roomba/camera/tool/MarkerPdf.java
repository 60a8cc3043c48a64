package org.evoloop.roomba.camera.tool;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.evoloop.roomba.camera.MarkerSpec;

/** A page to print: the marker to scale, a ruler to check the scale, and how to mount it. PDF 1.4, uncompressed. */
final class MarkerPdf {
    private static final double POINTS_PER_MM = 72 / 25.4;
    private static final double A4_WIDTH_MM = 210;
    private static final double A4_HEIGHT_MM = 297;

    /** Above and beside the marker: the white border belongs to the marker. */
    private static final double MARGIN_MM = 20;

    private static final double TEXT_MM = 85;
    private static final double RULER_MM = 100;
    private static final double LINE_MM = 5.5;

    private final MarkerSpec marker;
    private final double widthMm;
    private final double heightMm;
    private final StringBuilder drawing = new StringBuilder();

    private MarkerPdf(MarkerSpec marker) {
        this.marker = marker;
        widthMm = Math.max(A4_WIDTH_MM, marker.sideMm() + 2 * MARGIN_MM);
        heightMm = Math.max(A4_HEIGHT_MM, marker.sideMm() + 2 * MARGIN_MM + TEXT_MM);
    }

    static byte[] of(MarkerSpec marker) {
        MarkerPdf page = new MarkerPdf(marker);
        page.drawMarker();
        page.drawText();
        return page.file();
    }

    private void drawMarker() {
        boolean[][] cells = MarkerCells.of(marker);
        double leftMm = (widthMm - marker.sideMm()) / 2;
        double cellMm = marker.sideMm() / cells.length;
        drawing.append("0 g\n");
        rectangle(leftMm, MARGIN_MM, marker.sideMm(), marker.sideMm());
        drawing.append("1 g\n");
        for (int row = 0; row < cells.length; row++) {
            for (int column = 0; column < cells.length; column++) {
                if (cells[row][column]) {
                    rectangle(leftMm + column * cellMm, MARGIN_MM + row * cellMm, cellMm, cellMm);
                }
            }
        }
        drawing.append("0 g\n");
    }

    private void drawText() {
        double belowMm = marker.sideMm() + 2 * MARGIN_MM;
        rectangle(MARGIN_MM, belowMm, RULER_MM, 0.5);
        rectangle(MARGIN_MM, belowMm - 2, 0.5, 4.5);
        rectangle(MARGIN_MM + RULER_MM - 0.5, belowMm - 2, 0.5, 4.5);
        List<String> lines = List.of(
                "Evoloop starting point: ArUco " + marker.dictionary().label() + ", id " + marker.id() + ", side "
                        + millimetres() + " mm",
                "This line must be 100 mm long: print at 100 %, without \"fit to page\".",
                "",
                "How to mount it",
                "- Upright, this way up, facing where the robot comes from. The robot stops 0.40 m before it.",
                "- Its middle as high as the camera: about 150 mm above the floor.",
                "- On something flat and stiff; paper that bends spoils distance and bearing.",
                "- Matt paper, no glass or foil before it, out of direct sunlight.",
                "- Keep the white around it: at least 20 mm on each side.");
        for (int i = 0; i < lines.size(); i++) {
            text(lines.get(i), belowMm + 9 + i * LINE_MM);
        }
    }

    private String millimetres() {
        return marker.sideMm() == Math.rint(marker.sideMm())
                ? String.valueOf(Math.round(marker.sideMm()))
                : String.valueOf(marker.sideMm());
    }

    /** Position from the page's upper left corner, in mm. */
    private void rectangle(double leftMm, double topMm, double width, double height) {
        drawing.append(String.format(
                Locale.ROOT,
                "%.3f %.3f %.3f %.3f re f%n",
                leftMm * POINTS_PER_MM,
                (heightMm - topMm - height) * POINTS_PER_MM,
                width * POINTS_PER_MM,
                height * POINTS_PER_MM));
    }

    private void text(String line, double baselineMm) {
        drawing.append(String.format(
                Locale.ROOT,
                "BT /F1 11 Tf %.3f %.3f Td (%s) Tj ET%n",
                MARGIN_MM * POINTS_PER_MM,
                (heightMm - baselineMm) * POINTS_PER_MM,
                line.replace("\\", "\\\\").replace("(", "\\(").replace(")", "\\)")));
    }

    private byte[] file() {
        List<String> objects = List.of(
                "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
                "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
                String.format(
                        Locale.ROOT,
                        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 %.3f %.3f] /Contents 4 0 R "
                                + "/Resources << /Font << /F1 5 0 R >> >> >>",
                        widthMm * POINTS_PER_MM,
                        heightMm * POINTS_PER_MM),
                "<< /Length " + drawing.length() + " >>\nstream\n" + drawing + "endstream",
                "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>");
        StringBuilder file = new StringBuilder("%PDF-1.4\n");
        List<Integer> offsets = new ArrayList<>();
        for (int i = 0; i < objects.size(); i++) {
            offsets.add(file.length());
            file.append(i + 1).append(" 0 obj\n").append(objects.get(i)).append("\nendobj\n");
        }
        int table = file.length();
        // Each entry of the table has 20 bytes.
        file.append("xref\n0 ").append(objects.size() + 1).append("\n0000000000 65535 f \n");
        offsets.forEach(offset -> file.append(String.format(Locale.ROOT, "%010d 00000 n \n", offset)));
        file.append("trailer\n<< /Size ")
                .append(objects.size() + 1)
                .append(" /Root 1 0 R >>\nstartxref\n")
                .append(table)
                .append("\n%%EOF\n");
        return file.toString().getBytes(StandardCharsets.US_ASCII);
    }
}
