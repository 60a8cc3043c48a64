package org.evoloop.models.diagram;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.longs;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.models.chart.FlatMachineChart;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Wire;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Diagrams are legible: nothing overlaps. */
class LayoutTest {
    private record Area(String what, double x, double y, double width, double height) {
        boolean overlaps(Area other) {
            return x < other.x + other.width - 1
                    && other.x < x + width - 1
                    && y < other.y + other.height - 1
                    && other.y < y + height - 1;
        }
    }

    private static final List<String> EVENTS = List.of(
            "press", "t", "the battery is nearly empty and the dock is far away", "時間切れになりました", "done [ok] / beep()");

    private static Diagram random(int states, int transitions, long seed) {
        Random random = new Random(seed);
        StateMachineBuilder builder = StateMachine.named("m").initial("State0");
        for (int i = 1; i < states; i++) {
            builder.transition("State" + random.nextInt(i), "go" + i, "State" + i);
        }
        for (int i = 0; i < transitions; i++) {
            String source = "State" + random.nextInt(states);
            String target = random.nextInt(4) == 0 ? source : "State" + random.nextInt(states);
            builder.transition(source, EVENTS.get(i % EVENTS.size()) + i, target);
        }
        return ChartDiagram.of(FlatMachineChart.of(builder.build()));
    }

    private static List<Area> areas(Layout layout) {
        List<Area> areas = new ArrayList<>();
        for (Box box : layout.boxes()) {
            areas.add(new Area(box.node().name(), box.x(), box.y(), box.width(), box.height()));
        }
        for (Wire wire : layout.wires()) {
            if (!wire.label().isEmpty()) {
                areas.add(new Area(
                        wire.edge().label(),
                        wire.at().x(),
                        wire.at().y(),
                        TextSize.width(wire.label(), false),
                        TextSize.height(wire.label())));
            }
        }
        return areas;
    }

    @ParameterizedTest
    @CsvSource({"4,4,1", "4,12,2", "12,12,3", "12,24,4", "40,30,5", "40,60,6"})
    void noStateAndNoLabelLiesOnAnother(int states, int transitions, long seed) {
        Layout layout = ElkLayout.of(random(states, transitions, seed));
        List<Area> areas = areas(layout);

        for (int i = 0; i < areas.size(); i++) {
            Area one = areas.get(i);
            assertThat(areas.subList(i + 1, areas.size()))
                    .as("elements that overlap " + one + " (seed " + seed + ")")
                    .noneMatch(one::overlaps);
            assertThat(one.x()).isNotNegative();
            assertThat(one.x() + one.width()).isLessThanOrEqualTo(layout.width());
            assertThat(one.y() + one.height()).isLessThanOrEqualTo(layout.height());
        }
    }

    /** However states are nested, and wherever arcs lead. */
    @Test
    void noLabelLiesOnAnythingWhereStatesAreInStates() {
        qt().withExamples(60).forAll(longs().all()).checkAssert(LayoutTest::assertThatNothingLiesOnALabel);
    }

    /** Charts for which ELK fails if initial pseudostates are constrained to the first layer. */
    @ParameterizedTest
    @ValueSource(longs = {-67404428, -1963360})
    void whereNothingCanComeFirstThePictureIsStillGood(long seed) {
        assertThatNothingLiesOnALabel(seed);
    }

    private static void assertThatNothingLiesOnALabel(long seed) {
        Layout layout = ElkLayout.of(ChartDiagram.of(RandomChart.of(seed)));
        List<Area> areas = areas(layout);
        List<Area> labels = areas.subList(layout.boxes().size(), areas.size());
        List<Area> solid = new ArrayList<>(labels);
        for (int i = 0; i < layout.boxes().size(); i++) {
            Diagram.Node node = layout.boxes().get(i).node();
            if (node.children().isEmpty() && node.shape() != Shape.REGION) {
                solid.add(areas.get(i));
            }
        }
        for (Area label : labels) {
            assertThat(solid).filteredOn(label::overlaps).containsExactly(label);
        }
    }

    @Test
    void everyTransitionIsDrawnOnceWithRightAngles() {
        Diagram diagram = random(12, 30, 7);
        Layout layout = ElkLayout.of(diagram);

        assertThat(layout.wires()).extracting(Wire::edge).containsExactlyElementsOf(diagram.edges());
        for (Wire wire : layout.wires()) {
            for (int i = 1; i < wire.points().size(); i++) {
                Layout.Point from = wire.points().get(i - 1);
                Layout.Point to = wire.points().get(i);
                assertThat(Math.min(Math.abs(from.x() - to.x()), Math.abs(from.y() - to.y())))
                        .isLessThan(0.01);
            }
        }
    }

    @Test
    void textFitsItsState() {
        Diagram diagram = random(4, 4, 8);
        for (Box box : ElkLayout.of(diagram).boxes()) {
            if (box.node().shape() == Shape.STATE) {
                assertThat(box.width()).isGreaterThan(TextSize.width(NodeSize.name(box.node()), true));
            }
        }
    }

    @Test
    void theSameDiagramIsTheSamePicture() {
        assertThat(SvgWriter.write("m", List.of(random(12, 12, 9))))
                .isEqualTo(SvgWriter.write("m", List.of(random(12, 12, 9))));
    }

    @Test
    void longNamesAreBrokenAndShortOnesAreNot() {
        assertThat(TextSize.wrap("On", 100, false)).containsExactly("On");
        assertThat(TextSize.wrap("", 100, false)).isEmpty();
        assertThat(TextSize.wrap("waitingForTheOwnerToComeBack", 120, false))
                .containsExactly("waitingForThe", "OwnerToCome", "Back");
        assertThat(TextSize.wrap("an event of many words", 80, false)).containsExactly("an event of", "many words");
        assertThat(String.join("", TextSize.wrap("ボタンが長押しされました", 60, false))).isEqualTo("ボタンが長押しされました");
    }
}
