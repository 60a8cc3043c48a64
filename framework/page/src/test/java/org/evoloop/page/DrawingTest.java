package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import org.evoloop.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.page.drawing.MachineDrawing;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
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
                transitions.add(each.event() + "|" + each.source() + "|" + each.target() + "|");
            }
            assertThat(with(drawn, "g", "data-event", "data-source", "data-target"))
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

    private static StateMachine airConditioner() {
        StateMachineBuilder builder = StateMachine.named("ac");
        for (String mode : List.of("Cool", "Dry", "Fan")) {
            builder.drawn(new State(mode), new State(mode), List.of(), List.of("Modes." + mode), false);
            String boost = "Boost [history " + mode + "]";
            builder.drawn(new State(boost), new State("Boost"), List.of(), List.of("Boost"), false);
        }
        builder.initial("Off").transition("Off", "power", "Cool");
        builder.transition("Cool", "mode", "Dry")
                .transition("Dry", "mode", "Fan")
                .transition("Fan", "mode", "Cool");
        for (String mode : List.of("Cool", "Dry", "Fan")) {
            String boost = "Boost [history " + mode + "]";
            builder.transition(mode, "power", "Off")
                    .transition(mode, "long", boost)
                    .transition(boost, "long", mode)
                    .transition(boost, "power", "Off");
        }
        return builder.build();
    }

    @Test
    void aCompositeStateIsAFrameAroundItsStatesAndNoOthers() throws Exception {
        Document drawn = drawn(airConditioner());
        assertThat(with(drawn, "g", "data-composite")).containsExactly("Modes|");
        Element frame = null;
        Map<String, Element> boxes = new HashMap<>();
        NodeList all = drawn.getElementsByTagName("rect");
        for (int i = 0; i < all.getLength(); i++) {
            Element box = (Element) all.item(i);
            String state = ((Element) box.getParentNode()).getAttribute("data-state");
            frame = state.isEmpty() ? box : frame;
            boxes.put(state, box);
        }
        for (String inside : List.of("Cool", "Dry", "Fan")) {
            assertThat(isIn(frame, boxes.get(inside))).as(inside).isTrue();
        }
        for (String outside : List.of("Off", "Boost")) {
            assertThat(overlap(frame, boxes.get(outside))).as(outside).isFalse();
        }
    }

    @Test
    void aCompositeStateInAnotherIsAFrameInItsFrame() throws Exception {
        StateMachineBuilder builder = StateMachine.named("fan").initial("Off").transition("Off", "power", "Idle");
        for (String path : List.of("On.Idle", "On.Fast.Low", "On.Fast.High", "On.Slow.Calm")) {
            State state = new State(path.substring(path.lastIndexOf('.') + 1));
            builder.drawn(state, state, List.of(), List.of(path), false);
            builder.transition(state.name(), "power", "Off");
        }
        Document drawn = drawn(builder.transition("Idle", "fast", "Low")
                .transition("Low", "fast", "High")
                .transition("High", "slow", "Calm")
                .build());

        Map<String, Element> boxes = new HashMap<>();
        NodeList all = drawn.getElementsByTagName("rect");
        for (int i = 0; i < all.getLength(); i++) {
            Element parent = (Element) all.item(i).getParentNode();
            boxes.put(parent.getAttribute("data-state") + parent.getAttribute("data-composite"), (Element) all.item(i));
        }
        assertThat(boxes).containsOnlyKeys("Off", "Idle", "Low", "High", "Calm", "On", "On.Fast", "On.Slow");
        Map<String, List<String>> inside = Map.of(
                "On", List.of("Idle", "Low", "High", "Calm", "On.Fast", "On.Slow"),
                "On.Fast", List.of("Low", "High"),
                "On.Slow", List.of("Calm"));
        inside.forEach((frame, members) -> boxes.forEach((name, box) -> {
            if (members.contains(name)) {
                assertThat(isIn(boxes.get(frame), box))
                        .as("%s in %s", name, frame)
                        .isTrue();
            } else if (!frame.equals(name) && !name.equals("On")) {
                assertThat(overlap(boxes.get(frame), box))
                        .as("%s beside %s", name, frame)
                        .isFalse();
            }
        }));
    }

    @Test
    void statesThatDifferInWhatIsRememberedAreOneAsDrawn() throws Exception {
        Document drawn = drawn(airConditioner());
        assertThat(with(drawn, "g", "data-state")).containsExactlyInAnyOrder("Off|", "Cool|", "Dry|", "Fan|", "Boost|");
        assertThat(with(drawn, "g", "data-source", "data-target", "data-event"))
                .contains("Cool|Boost|long|", "Boost|Fan|long|", "Boost|Off|power|");
    }

    @Test
    void inTheOverviewACompositeStateIsOneBox() throws Exception {
        String svg = MachineDrawing.overview(airConditioner(), state -> false);
        Document drawn = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
        assertThat(with(drawn, "g", "data-state")).containsExactlyInAnyOrder("Off|", "Modes|", "Boost|");
        assertThat(with(drawn, "g", "data-source", "data-target", "data-event"))
                .contains("Modes|Boost|long|", "Modes|Off|power|")
                .doesNotContain("Modes|Modes|mode|");
        assertThat(MachineDrawing.overview(PaperModels.cleaningRobot().evolved(), state -> false))
                .as("it has none")
                .isEmpty();
    }

    private static boolean isIn(Element frame, Element box) {
        return at(frame, "x") <= at(box, "x")
                && at(frame, "y") <= at(box, "y")
                && at(box, "x") + at(box, "width") <= at(frame, "x") + at(frame, "width")
                && at(box, "y") + at(box, "height") <= at(frame, "y") + at(frame, "height");
    }

    private static boolean overlap(Element one, Element other) {
        return at(one, "x") < at(other, "x") + at(other, "width")
                && at(other, "x") < at(one, "x") + at(one, "width")
                && at(one, "y") < at(other, "y") + at(other, "height")
                && at(other, "y") < at(one, "y") + at(one, "height");
    }

    @Test
    void noStateLiesOnAnother() throws Exception {
        Document drawn = drawn(PaperModels.cleaningRobot().evolved());
        NodeList boxes = drawn.getElementsByTagName("rect");
        for (int i = 0; i < boxes.getLength(); i++) {
            for (int j = i + 1; j < boxes.getLength(); j++) {
                Element one = (Element) boxes.item(i);
                Element other = (Element) boxes.item(j);
                assertThat(overlap(one, other)).isFalse();
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
