package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.PaperModels;
import org.junit.jupiter.api.Test;

class ModelPictureTest {
    @Test
    void itIsWellFormedAndBringsItsColours() throws Exception {
        String svg = ModelPicture.of(PaperModels.lightBulb());
        DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
        assertThat(svg)
                .startsWith("<svg class=\"chart\" data-theme=\"light\"")
                .contains("--ink:", ".chart .box {", "<marker id=\"arrow\"", "data-state=\"incandescentOn\"");
    }

    @Test
    void ofAWideOneOnlyWhatIsNewIsDrawn() {
        String svg = ModelPicture.of(PaperModels.cleaningRobot());
        assertThat(svg)
                .contains("data-state=\"Move\"", "data-event=\"arriveSpot\"")
                .doesNotContain("data-state=\"Charging\"");
    }
}
