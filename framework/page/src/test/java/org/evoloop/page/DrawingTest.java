package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.MachineDrawing;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class DrawingTest {
    private static Document drawn(StateMachine machine) throws Exception {
        String svg = MachineDrawing.of(machine, state -> false);
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
    }

    private static Set<String> with(Document drawn, String name, String... attributes) {
        Set<String> found = new HashSet<>();
        NodeList all = drawn.getElementsByTagName(name);
        for (int i = 0; i < all.getLength(); i++) {
            Element element = (Element) all.item(i);
            StringBuilder text = new StringBuilder();
            for (String attribute : attributes) {
                text.append(element.getAttribute(attribute)).append('|');
            }
            if (element.hasAttribute(attributes[0])) {
                found.add(text.toString());
            }
        }
        return found;
    }

    @Test
    void everyStateAndTransitionIsThereUnderItsName() throws Exception {
        ModelPair pair = PaperModels.cleaningRobot();
        for (StateMachine machine : new StateMachine[] {pair.original(), pair.evolved()}) {
            Document drawn = drawn(machine);
            Set<String> states = new HashSet<>();
            machine.states().forEach(state -> states.add(state.name() + "|"));
            assertThat(with(drawn, "g", "data-state")).isEqualTo(states);
            Set<String> transitions = new HashSet<>();
            for (Transition each : machine.transitions()) {
                transitions.add(each.source() + "|" + each.event() + "|" + each.target() + "|");
            }
            assertThat(with(drawn, "text", "data-source", "data-event", "data-target"))
                    .isEqualTo(transitions);
        }
    }

    @Test
    void aStateThatUsesTheDeviceSaysSo() {
        StateMachine door = StateMachine.named("door")
                .initial("Closed")
                .transition("Closed", "gap", "Gap")
                .deviceState("Gap", "StopUp")
                .sends("Gap", "light")
                .build();

        assertThat(MachineDrawing.of(door, state -> false))
                .containsOnlyOnce("<title>Gap, the device in StopUp; may send light</title></g>");
    }

    @Test
    void noStateLiesOnAnother() throws Exception {
        Document drawn = drawn(PaperModels.cleaningRobot().evolved());
        NodeList boxes = drawn.getElementsByTagName("rect");
        for (int i = 0; i < boxes.getLength(); i++) {
            for (int j = i + 1; j < boxes.getLength(); j++) {
                Element one = (Element) boxes.item(i);
                Element other = (Element) boxes.item(j);
                boolean apart = at(one, "x") + at(one, "width") < at(other, "x")
                        || at(other, "x") + at(other, "width") < at(one, "x")
                        || at(one, "y") + at(one, "height") < at(other, "y")
                        || at(other, "y") + at(other, "height") < at(one, "y");
                assertThat(apart).isTrue();
            }
        }
    }

    private static double at(Element box, String attribute) {
        return Double.parseDouble(box.getAttribute(attribute));
    }

    @Test
    void namesAreAlwaysShownAsText() throws Exception {
        StateMachine odd = StateMachine.named("odd")
                .initial("<script>\"&'")
                .transition("<script>\"&'", "a\u0001b", "<script>\"&'")
                .transition("<script>\"&'", "x", "état \uD83D\uDE00")
                .build();
        assertThat(with(drawn(odd), "g", "data-state")).contains("<script>\"&'|", "état \uD83D\uDE00|");
    }

    @Test
    void whatIsTooLargeToBeSeenIsNotDrawn() {
        var ring = StateMachine.named("ring").initial("s0");
        for (int i = 0; i < 2000; i++) {
            ring.transition("s" + i, "next", "s" + (i + 1) % 2000);
        }
        assertThat(MachineDrawing.of(ring.build(), state -> false)).isEmpty();
    }
}
