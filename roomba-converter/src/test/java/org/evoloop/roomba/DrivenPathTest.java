package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.util.List;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.OdometryPose;
import org.evoloop.roomba.session.Telemetry;
import org.junit.jupiter.api.Test;
import org.xml.sax.InputSource;

class DrivenPathTest {
    private static final Pattern STEP = Pattern.compile(" L");

    private final DrivenPath way = new DrivenPath();
    private long frame;

    private void at(double xMm, double yMm, double headingRad) {
        frame++;
        way.received(
                new Telemetry(frame, SensorValues.of(List.of(), packet -> 0), new OdometryPose(xMm, yMm, headingRad)));
    }

    private static long steps(String svg) {
        return STEP.matcher(svg.substring(svg.indexOf("class=\"way\"")))
                .results()
                .count();
    }

    @Test
    void beforeTheRobotAnswersThereIsNoPicture() {
        assertThat(way.svg(true)).isEmpty();
    }

    @Test
    void aheadIsUpwardsAndLeftIsLeft() throws Exception {
        at(0, 0, 0);
        at(1_000, 0, 0);
        at(1_000, 500, Math.PI / 2);

        String svg = way.svg(true);

        // 1500 mm are 600 pixels, with a margin of 250 mm round the path.
        assertThat(svg).contains("d=\"M500 500 L500 100 L300 100 L300 100\"");
        assertThat(svg)
                .contains("<circle class=\"robot\" cx=\"300\" cy=\"100\" r=\"68\"/>")
                .doesNotContain("out of reach");
        assertThat(way.svg(false)).contains("out of reach: where it was last");
        assertThat(DocumentBuilderFactory.newInstance()
                        .newDocumentBuilder()
                        .parse(new InputSource(new StringReader(svg)))
                        .getDocumentElement()
                        .getTagName())
                .isEqualTo("svg");
    }

    @Test
    void aLongWayIsKeptFromItsBeginningWithABoundedNumberOfPoints() {
        for (int step = 0; step < 100_000; step++) {
            at(step * 25.0, 0, 0);
        }

        String svg = way.svg(true);

        assertThat(steps(svg)).isBetween(1_500L, 4_002L);
        assertThat(svg).startsWith("<svg").hasSizeLessThan(100_000);
    }
}
