package org.evoloop.check.properties;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.check.Lamp.lamp;

import java.util.List;
import java.util.stream.Stream;
import org.evoloop.check.timing.Assumption;
import org.evoloop.check.timing.TimeForm;
import org.evoloop.check.timing.TimeProperty;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What a property file may say about time, and how mistakes in it are reported. */
class TimeLinesTest {
    private static final ModelPair LAMP = new ModelPair(
            lamp("original").build(),
            lamp("new")
                    .transition("On", "warm", "Warm")
                    .transition("Warm", "cool", "On")
                    .transition("Off", "after 3 s", "3")
                    .build());

    private static TimeRules read(String... lines) {
        return PropertyFile.parse("lamp.txt", String.join("\n", lines), LAMP).time();
    }

    @Test
    void everyFormIsRead() {
        TimeRules rules = read(
                "It answers: after event press, state On or Off within 3 s",
                "after Warm and not device Off, On within 200ms..1.5s",
                "Warm never longer than 10 min",
                "Warm never shorter than 0.5 s",
                "Warm only after 30 s",
                "    of On",
                "event press at most 3 times in 10 s");

        assertThat(rules.properties())
                .extracting(TimeProperty::form)
                .extracting(TimeForm::nanos)
                .containsExactly(
                        List.of(0L, 3_000_000_000L),
                        List.of(200_000_000L, 1_500_000_000L),
                        List.of(600_000_000_000L),
                        List.of(500_000_000L),
                        List.of(30_000_000_000L),
                        List.of(10_000_000_000L));
        assertThat(rules.properties()).extracting(TimeProperty::line).containsExactly(1, 2, 3, 4, 5, 7);
        assertThat(rules.properties().get(0).name()).isEqualTo("It answers");
        assertThat(rules.properties().get(5).form())
                .isInstanceOfSatisfying(
                        TimeForm.Count.class, count -> assertThat(count.most()).isEqualTo(3));
    }

    @Test
    void whatIsKnownAndWhatFollowsIsRead() {
        TimeRules rules = read(
                "The relay is slow: takes press 200 ms .. 1 s",
                "at least 150 ms between presses",
                "at least 1 s between warm",
                "cool comes 1 s .. 5 min after function Warm",
                "queue 2",
                "Too warm: Warm never longer than 1 min",
                "on violation of Too warm raise cool");

        assertThat(rules.assumptions()).hasSize(5).hasOnlyElementsOfType(Assumption.class);
        assertThat(rules.assumptions().get(0))
                .isInstanceOfSatisfying(
                        Assumption.Takes.class,
                        takes -> assertThat(takes.span()).hasToString("200 ms .. 1 s"));
        assertThat(rules.reactions()).singleElement().satisfies(reaction -> {
            assertThat(reaction.property()).isEqualTo("Too warm");
            assertThat(reaction.event()).hasToString("cool");
        });
    }

    @Test
    void whatIsNotAboutTimeStaysAsItWas() {
        PropertyFile file = PropertyFile.parse(
                "lamp.txt", "at least once: can Warm\nOn only after event press\nalways (3 implies can On)", LAMP);

        assertThat(file.time()).isEqualTo(TimeRules.NONE);
        assertThat(file.properties()).hasSize(3);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                Arguments.of("after event dance, On within 3 s", "there is no event of the new model named dance"),
                Arguments.of(
                        "after event press On within 3 s", "there is no comma between what happens and what follows"),
                Arguments.of("after event press, On within 3", "'3' is not a length of time; write a number and ms"),
                Arguments.of("after event press, On within 3 days", "'3 days' is not a length of time"),
                Arguments.of("after event press, On within 3 s .. 1 s", "the interval 3 s .. 1 s is empty"),
                Arguments.of("after event press, On within less than 3 s", "'less than 3 s' excludes its end"),
                Arguments.of("after event press, can On within 3 s", "'can On' is about more than one moment"),
                Arguments.of("always (after event press, On within 3 s)", "a property with a time in it must be alone"),
                Arguments.of("eventually On within 3 s", "a property with a time in it must be alone"),
                Arguments.of("event press never longer than 3 s", "an event takes no time, so it cannot last"),
                Arguments.of("Warm never longer than 0 s", "everything lasts at least 0 s"),
                Arguments.of("Warm never longer than 99999 h", "'99999 h' is too long"),
                Arguments.of("Warm never longer than 0.00000001 ms", "'0.00000001 ms' is too fine"),
                Arguments.of("On at most 0 times in 3 s", "'at most 0 times in 3 s' cannot be understood"),
                Arguments.of("takes dance 1 s", "there is no event of the original model named dance"),
                Arguments.of("takes press 2 s .. 1 s", "the interval 2 s .. 1 s is empty"),
                Arguments.of("at least 1 s after presses", "write at least 150 ms between presses"),
                Arguments.of("cool comes 1 s", "say after what"),
                Arguments.of("cool comes 1 s after event press", "'event press' does not last"),
                Arguments.of("queue many", "'many' events cannot wait"),
                Arguments.of("on violation of X raise dance", "there is no event of the new model named dance"),
                Arguments.of("on violation of X raise cool", "no time property is named 'X'; there is none"),
                Arguments.of("on violation raise cool", "write on violation of NAME raise EVENT"));
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void eachMistakeIsNamedWithItsLine(String line, String message) {
        assertThatThrownBy(() -> read("# first", line))
                .isInstanceOf(ModelException.class)
                .message()
                .startsWith("lamp.txt, line 2: " + message)
                .hasLineCount(1);
    }

    static Stream<Arguments> contradictions() {
        return Stream.of(
                Arguments.of("a: Warm never longer than 1 s", "b: Warm never shorter than 2 s", "contradicts line 1"),
                Arguments.of("a: On never longer than 1 s", "b: Warm only after 2 s of On", "contradicts line 1"),
                Arguments.of("a: after On, Off within 1 s", "b: after On, Off within 2 s .. 3 s", "contradicts line 1"),
                Arguments.of("a: after On, Off within 2 s .. 3 s", "b: after On, Off within 1 s", "contradicts line 1"),
                Arguments.of("a: On never longer than 1 s", "a: Off never longer than 1 s", "has the name 'a', too"),
                Arguments.of("takes press 1 s", "takes press 2 s", "line 1 already says how long that is"),
                Arguments.of("queue 1", "queue 2", "line 1 already says how long that is"));
    }

    @ParameterizedTest
    @MethodSource("contradictions")
    void whatCannotBothBeSoIsRefused(String first, String second, String message) {
        assertThatThrownBy(() -> read(first, second))
                .isInstanceOf(ModelException.class)
                .message()
                .startsWith("lamp.txt, line 2: ")
                .contains(message)
                .hasLineCount(1);
    }
}
