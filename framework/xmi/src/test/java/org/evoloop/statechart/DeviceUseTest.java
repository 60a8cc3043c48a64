package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.named;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;

import java.util.List;
import java.util.Set;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What drawn states have to do with the device, and what becomes of it in the flat machine. */
class DeviceUseTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Gap                            | Gap   |        |",
                "«device StopUp» Gap            | Gap   | StopUp |",
                "<<device StopUp>>Gap           | Gap   | StopUp |",
                "Gap « device  Stop Up »        | Gap   | Stop Up|",
                "«device (Heat, Fan)» Warm      | Warm  | (Heat, Fan) |",
                "«sends speed, stop» Storm      | Storm |        | speed stop",
                "«device On, sends speed» Storm | Storm | On     | speed",
                "«sends a,b, device On» Storm   | Storm | On     | a b",
                "«device On» «sends a» Storm    | Storm | On     | a",
                "A « B                          | A « B |        |"
            })
    void shouldReadKeywordsBesideTheName(String drawn, String name, String device, String sends) {
        Vertex.ChartState state = Vertex.ChartState.simple("s", drawn, Place.NONE);

        assertThat(state.name()).isEqualTo(name);
        assertThat(state.use().device()).isEqualTo(device == null ? "" : device);
        assertThat(String.join(" ", state.use().sends())).isEqualTo(sends == null ? "" : sends);
        assertThat(Vertex.ChartState.simple("s", state.use().mark(name), Place.NONE))
                .isEqualTo(state);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "«devise StopUp» Gap        | unknown keyword 'devise StopUp'; did you mean device?",
                "«send speed» Gap           | unknown keyword 'send speed'; did you mean sends?",
                "Gap <<Device StopUp>>      | unknown keyword 'Device StopUp'; did you mean device?",
                "«spontaneous» Gap          | unknown keyword 'spontaneous'; write «device STATE» or «sends EVENT, EVENT»",
                "«device» Gap               | incomplete keyword 'device'; write «device STATE»",
                "«sends a,» Gap             | incomplete keyword 'sends a,'; write «device STATE» or «sends EVENT, EVENT»",
                "«device A» «device B» Gap  | a second device state, 'device B'; keep one",
                "«device A Gap              | a keyword without an end; write » or >> after it"
            })
    void shouldRefuseWhatItDoesNotUnderstand(String drawn, String message) {
        assertThat(texts(chart(region(initial("i"), named("s", drawn)), arc("i s"))))
                .singleElement()
                .asString()
                .contains(message);
    }

    @Test
    void shouldRefuseMisspeltAndMisplacedKeywords() {
        assertThat(problems(chart(
                        region(initial("i"), named("s", "S")),
                        arc("i s"),
                        new Arc(Place.NONE, "s", "s", List.of("«spontanous» end"), "", List.of(), Arc.Kind.EXTERNAL))))
                .singleElement()
                .asString()
                .contains("event '«spontanous» end' has the unknown keyword 'spontanous'; did you mean spontaneous?");
        assertThat(problems(chart(
                        region(initial("i"), named("s", "S"), new Vertex.FinalState("f", "«device A»", Place.NONE)),
                        arc("i s"),
                        arc("s f e"))))
                .singleElement()
                .asString()
                .contains("has a keyword; draw it at a state");
    }

    @Test
    void theInnermostDeviceStateWins() {
        StateMachine machine = Flattening.flatten(chart(
                region(
                        initial("i"),
                        named("s", "S"),
                        named(
                                "o",
                                "«device Turbo» «sends a» Boost",
                                region(initial("j"), named("x", "Strong"), named("y", "«device Dry, sends b» Mild")))),
                arc("i s"),
                arc("s o e"),
                arc("j x"),
                arc("x y e"),
                arc("o s f")));

        assertThat(machine.states())
                .extracting(State::name, machine::deviceState, machine::inheritsDeviceState, machine::sends)
                .contains(
                        tuple("S", null, false, Set.of()),
                        tuple("Strong", "Turbo", true, Set.of(new Event("a"))),
                        tuple("Mild", "Dry", false, Set.of(new Event("a"), new Event("b"))));
    }

    @Test
    void everyVariantOfAHistoryHasTheDeviceState() {
        StateMachine machine = Flattening.flatten(chart(
                region(
                        initial("i"),
                        named(
                                "m",
                                "Modes",
                                region(
                                        initial("j"),
                                        pseudo("h", Kind.SHALLOW_HISTORY),
                                        named("c", "Cool"),
                                        named("d", "Dry"))),
                        named("b", "«device Turbo» Boost")),
                arc("i m"),
                arc("j c"),
                arc("c d mode"),
                arc("d c mode"),
                arc("m b long"),
                arc("b h long")));

        assertThat(machine.states().stream().filter(state -> state.name().startsWith("Boost")))
                .hasSize(2)
                .allMatch(state -> "Turbo".equals(machine.deviceState(state)));
    }

    private static Statechart regions(String left, String right) {
        return chart(
                region(
                        initial("i"),
                        named(
                                "o",
                                "«device Turbo» Both",
                                new Region(
                                        "R1",
                                        Place.NONE,
                                        List.of(initial("j"), named("a", left), named("b", "B")),
                                        List.of()),
                                new Region(
                                        "R2",
                                        Place.NONE,
                                        List.of(initial("k"), named("c", right), named("d", "D")),
                                        List.of()))),
                arc("i o"),
                arc("j a"),
                arc("a b e"),
                arc("k c"),
                arc("c d f"));
    }

    @Test
    void regionsThatAreActiveTogetherMustAgree() {
        assertThat(texts(regions("«device Low» A", "«device High» C")))
                .singleElement()
                .asString()
                .contains("the device must be in Low in state 'Both.A' and in High in state 'Both.C', which are active"
                        + " together in regions 'R1' and 'R2'; let them agree");
        StateMachine machine = Flattening.flatten(regions("«device Low» A", "«device Low» C"));
        assertThat(machine.states())
                .extracting(State::name, machine::deviceState)
                .containsExactlyInAnyOrder(
                        tuple("(A, C)", "Low"),
                        tuple("(B, C)", "Low"),
                        tuple("(A, D)", "Low"),
                        tuple("(B, D)", "Turbo"));
    }

    /** Without places and ids. */
    private static List<String> texts(Statechart chart) {
        return problems(chart).stream()
                .map(problem -> problem.message() + "; " + problem.remedy())
                .toList();
    }

    private static List<Problem> problems(Statechart chart) {
        return Flattening.of(chart).problems();
    }
}
