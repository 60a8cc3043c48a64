package org.evoloop.check.properties;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.check.Lamp.lamp;

import java.util.List;
import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.RuleSwitches;
import org.evoloop.check.temporal.Property;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;

/** What a property file may contain, and how mistakes in it are reported. */
class PropertyFileTest {
    private static final ModelPair LAMP = new ModelPair(
            lamp("original").build(),
            lamp("new")
                    .transition("On", "warm", "Warm")
                    .transition("On", "hot", "Hot")
                    .build());

    @Test
    void propertiesHaveNamesAndLines() {
        PropertyFile file = PropertyFile.parse("lamp.txt", """
                # a comment
                It goes off:
                    always
                    can Off

                off trap-state Warm: it cools down
                    by itself
                never (Hot and device Off)
                """, LAMP);
        assertThat(file.properties())
                .extracting(Property::name)
                .containsExactly("It goes off", "never (Hot and device Off)");
        assertThat(file.properties()).extracting(Property::line).containsExactly(2, 8);
        assertThat(PropertyFile.none().properties()).isEmpty();
    }

    @Test
    void aSwitchConcernsOneElement() {
        RuleSwitches switches = PropertyFile.parse(
                        "lamp.txt",
                        "off trap-state Warm: it cools down\noff trap-state \"On\": it was one\noff unraised-event hot: no",
                        LAMP)
                .switches();
        List<Finding> findings = Check.run(CheckInput.of(LAMP));
        assertThat(switches.left(findings))
                .hasSize(findings.size() - 1)
                .noneMatch(each -> each.toString().contains("Warm"));
        assertThat(switches.off(findings)).singleElement().satisfies(off -> {
            assertThat(off.finding().element()).hasToString("Warm");
            assertThat(off.reason()).isEqualTo("it cools down");
            assertThat(off.where()).isEqualTo("lamp.txt, line 1");
        });
        assertThat(switches.useless(findings))
                .containsExactly("lamp.txt, line 2: trap-state does not find anything at On; remove the line");
    }

    @Test
    void everyMistakeIsNamedWithItsLine() {
        assertRefused(
                "never Dance\nnever event Dance\nnever device Warm\nnever function On\nOn Off\ncan (On\nOn only Off\nnot",
                "line 1: there is no state of the new model named Dance; there are Hot, Off, On, Warm",
                "line 2: there is no event of the new model named Dance",
                "line 3: there is no state of the original model named Warm",
                "line 4: there is no new state named On; there are Hot, Warm",
                "line 5: 'Off' stands where 'and', 'or', 'implies' or the end should, after 'On'",
                "line 6: the end stands where ')' should",
                "line 7: 'Off' stands where 'after' should",
                "line 8: the end stands where a name should");
        assertRefused(
                "off trap-state Cold: there is none\noff trap-state Warm\noff trap-states Warm: no such rule\n"
                        + "off trap-state: nothing named\noff property Warm: not so",
                "line 1: no model has 'Cold'",
                "line 2: say why trap-state does not matter for Warm",
                "line 3: there is no rule trap-states; choose from: condition-1, ",
                "line 4: no model has an element without a name",
                "line 5: a property is switched off by removing it");
    }

    private static void assertRefused(String text, String... messages) {
        assertThatThrownBy(() -> PropertyFile.parse("lamp.txt", text, LAMP))
                .isInstanceOf(ModelException.class)
                .message()
                .satisfies(error -> assertThat(error.lines().toList())
                        .hasSameSizeAs(messages)
                        .zipSatisfy(
                                List.of(messages),
                                (line, message) -> assertThat(line).startsWith("lamp.txt, " + message)));
    }
}
