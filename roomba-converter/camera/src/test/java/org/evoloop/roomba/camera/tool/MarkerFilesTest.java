package org.evoloop.roomba.camera.tool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** OpenCV finds the printed marker, and it is to scale. */
class MarkerFilesTest {
    private static final double POINTS_PER_MM = 72 / 25.4;
    private static final Pattern DRAWN = Pattern.compile("([01]) g|([\\d.]+) ([\\d.]+) ([\\d.]+) ([\\d.]+) re f");

    private static MarkerSpec marker(int id) {
        return new MarkerSpec(MarkerDictionary.ARUCO_4X4_50, id, 150);
    }

    @Test
    void theMarkersKnownWithoutOpenCvAreOpenCvs() {
        for (int id = 0; id < 50; id++) {
            assertThat(MarkerCells.of(marker(id)))
                    .as("marker %d", id)
                    .isDeepEqualTo(OpenCv.vision().markerCells(MarkerDictionary.ARUCO_4X4_50, id));
        }
    }

    @Test
    void otherDictionariesComeFromOpenCv() {
        boolean[][] cells = MarkerCells.of(new MarkerSpec(MarkerDictionary.APRILTAG_36H11, 586, 150));
        assertThat(cells).hasDimensions(8, 8);
        for (int i = 0; i < 8; i++) {
            assertThat(cells[0][i] || cells[7][i] || cells[i][0] || cells[i][7])
                    .as("border, cell %d", i)
                    .isFalse();
        }
    }

    /**
     * Paints the page as a camera with a focal length of 500 px sees it from the distance at which a point is a pixel.
     */
    @ParameterizedTest
    @ValueSource(ints = {0, 17, 49})
    void thePdfShowsTheMarkerToScale(int id) {
        String pdf = new String(MarkerPdf.of(marker(id)), StandardCharsets.US_ASCII);
        BufferedImage page = new BufferedImage(596, 842, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D painter = page.createGraphics();
        painter.setColor(Color.WHITE);
        painter.fillRect(0, 0, 596, 842);
        Matcher drawn = DRAWN.matcher(pdf);
        double widest = 0;
        while (drawn.find()) {
            if (drawn.group(1) != null) {
                painter.setColor(drawn.group(1).equals("0") ? Color.BLACK : Color.WHITE);
                continue;
            }
            double width = Double.parseDouble(drawn.group(4));
            double height = Double.parseDouble(drawn.group(5));
            widest = Math.max(widest, width);
            painter.fill(new Rectangle2D.Double(
                    Double.parseDouble(drawn.group(2)),
                    842 - Double.parseDouble(drawn.group(3)) - height,
                    width,
                    height));
        }
        painter.dispose();

        assertThat(widest).isCloseTo(150 * POINTS_PER_MM, within(0.001));
        double degrees = Math.toDegrees(2 * Math.atan(596 / 2.0 / 500));
        try (MarkerFinder finder = OpenCv.vision().finder(marker(id), new CameraModel.FieldOfView(degrees))) {
            assertThat(finder.find(Scene.pixels(page), 596, 842).orElseThrow().distanceMm())
                    .isCloseTo(500 / POINTS_PER_MM, within(2.0));
        }
    }

    @Test
    void thePdfsTableLeadsToItsObjects() {
        String pdf = new String(MarkerPdf.of(marker(3)), StandardCharsets.US_ASCII);
        int table = Integer.parseInt(pdf.replaceFirst("(?s).*startxref\n", "").replaceFirst("(?s)\n.*", ""));
        assertThat(pdf.substring(table)).startsWith("xref\n0 6\n");
        for (int object = 1; object <= 5; object++) {
            String entry =
                    pdf.substring(table + "xref\n0 6\n".length() + 20 * object).substring(0, 20);
            assertThat(entry).endsWith(" 00000 n \n");
            assertThat(pdf.substring(Integer.parseInt(entry.substring(0, 10)))).startsWith(object + " 0 obj\n");
        }
        Matcher stream =
                Pattern.compile("(?s)/Length (\\d+) >>\nstream\n(.*)endstream").matcher(pdf);
        assertThat(stream.find()).isTrue();
        assertThat(stream.group(2)).hasSize(Integer.parseInt(stream.group(1)));
        assertThat(pdf).contains("ArUco 4x4_50, id 3, side 150 mm");
    }

    @Test
    void thePngShowsTheMarkerAndKnowsItsSize() throws IOException {
        byte[] png = MarkerPng.of(marker(5));
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        int cellPx = picture.getWidth() / 8;
        int physical = new String(png, StandardCharsets.ISO_8859_1).indexOf("pHYs") + 4;
        double sideMm = 1000.0 * 6 * cellPx / ByteBuffer.wrap(png, physical, 4).getInt();
        assertThat(sideMm).isCloseTo(150, within(0.01));

        BufferedImage small = new BufferedImage(640, 640, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D painter = small.createGraphics();
        painter.drawImage(picture.getScaledInstance(640, 640, BufferedImage.SCALE_AREA_AVERAGING), 0, 0, null);
        painter.dispose();
        try (MarkerFinder finder = OpenCv.vision().finder(marker(5), CameraModel.DEFAULT)) {
            Sighting seen = finder.find(Scene.pixels(small), 640, 640).orElseThrow();
            assertThat(seen.bearingRad()).isCloseTo(0, within(0.01));
        }
    }
}
