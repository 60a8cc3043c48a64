package org.evoloop;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.converter.EventExecute;
import org.evoloop.engine.Core;
import org.junit.jupiter.api.Test;

/** Who follows an event from {@code getEvent} to {@code send} reads few files, and none of them twice. */
class EventPathTest {
    private static final Path DESIGN = Path.of(System.getProperty("evoloop.root"), "docs", "design.md");
    private static final Pattern ROW = Pattern.compile("^\\| `(\\w+)` \\|", Pattern.MULTILINE);

    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.evoloop.loop", "org.evoloop.converter", "org.evoloop.engine");

    private final List<JavaClass> path = path();

    private static List<JavaClass> path() {
        String design;
        try {
            design = Files.readString(DESIGN);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        String begin = "| file | what happens to the event |";
        String table = design.substring(design.indexOf(begin) + begin.length());
        return ROW.matcher(table.substring(0, table.indexOf("\n\n")))
                .results()
                .map(EventPathTest::named)
                .toList();
    }

    private static JavaClass named(MatchResult row) {
        return CLASSES.stream()
                .filter(each -> each.getSimpleName().equals(row.group(1)))
                .findAny()
                .orElseThrow(() -> new AssertionError("there is no class " + row.group(1)));
    }

    @Test
    void itIsShort() {
        assertThat(path).hasSizeBetween(1, 10);
    }

    @Test
    void eachFileLeadsToTheNext() {
        for (int index = 1; index < path.size(); index++) {
            JavaClass next = path.get(index);
            assertThat(path.subList(0, index))
                    .as("what leads to %s", next.getSimpleName())
                    .anyMatch(each -> calls(each).anyMatch(call -> isOf(next, call)));
        }
    }

    @Test
    void noFileLeadsBack() {
        for (int index = 1; index < path.size(); index++) {
            for (JavaClass before : path.subList(0, index)) {
                assertThat(calls(path.get(index)).filter(call -> isOf(before, call)))
                        .as("from %s to %s", path.get(index).getSimpleName(), before.getSimpleName())
                        .isEmpty();
            }
        }
    }

    /** What it calls of others; the end of the path is in a subclass of {@link EventExecute}, so that may be called. */
    private static Stream<JavaMethodCall> calls(JavaClass from) {
        return from.getMethodCallsFromSelf().stream()
                .filter(call -> !call.getTargetOwner().isAssignableFrom(from.getFullName()))
                .filter(call -> !call.getTargetOwner().isEquivalentTo(EventExecute.class)
                        || call.getName().equals("execute"));
    }

    /**
     * Whether the call may end in the file of {@code type}, also by way of an interface, a superclass, or the core, which
     * hands each input on to one of its parts.
     */
    private static boolean isOf(JavaClass type, JavaMethodCall call) {
        JavaClass core = CLASSES.get(Core.class);
        boolean part =
                core.getFields().stream().anyMatch(field -> field.getRawType().equals(type));
        return (part ? core : type).isAssignableTo(call.getTargetOwner().getFullName())
                && type.getMethods().stream()
                        .anyMatch(method -> method.getName().equals(call.getName()));
    }
}
