package org.evoloop.roomba;

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
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.evoloop.link.Link;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.Telemetry;
import org.junit.jupiter.api.Test;

/** Who follows a byte from the serial port to an occurrence reads few files, and none of them twice. */
class BytePathTest {
    private static final Path DESIGN = Path.of(System.getProperty("evoloop.root"), "docs", "design.md");
    private static final Pattern ROW = Pattern.compile("^\\| (`[^|]+) \\|", Pattern.MULTILINE);
    private static final Pattern NAME = Pattern.compile("`(\\w+)[.\\w]*`");
    private static final String READER = "RobotReader";

    /** What is read of a frame; whoever needs a value asks for it. */
    private static final Set<String> VALUES = Set.of(SensorValues.class.getName(), Telemetry.class.getName());

    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages(
                    "org.evoloop.link",
                    "org.evoloop.roomba",
                    "org.evoloop.roomba.oi",
                    "org.evoloop.roomba.session",
                    "org.evoloop.roomba.move");

    /** The files of each row. */
    private final List<List<JavaClass>> path = path();

    private static List<List<JavaClass>> path() {
        String design;
        try {
            design = Files.readString(DESIGN);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        String begin = "| file | what happens to the byte |";
        String table = design.substring(design.indexOf(begin) + begin.length());
        return ROW.matcher(table.substring(0, table.indexOf("\n\n")))
                .results()
                .map(row -> NAME.matcher(row.group(1))
                        .results()
                        .map(name -> named(name.group(1)))
                        .toList())
                .toList();
    }

    private static JavaClass named(String name) {
        return CLASSES.stream()
                .filter(each -> each.isTopLevelClass() && each.getSimpleName().equals(name))
                .findAny()
                .orElseThrow(() -> new AssertionError("there is no class " + name));
    }

    private List<JavaClass> before(int row) {
        return path.subList(0, row).stream().flatMap(List::stream).toList();
    }

    @Test
    void itIsShort() {
        assertThat(path).hasSizeBetween(2, 10);
        assertThat(path.stream().flatMap(List::stream)).doesNotHaveDuplicates();
    }

    @Test
    void eachFileLeadsToTheNext() {
        for (int row = 1; row < path.size(); row++) {
            for (JavaClass next : path.get(row)) {
                Stream<JavaClass> known = Stream.concat(before(row).stream(), path.get(row).stream());
                assertThat(known.filter(each -> !each.equals(next)))
                        .as("what leads to %s", next.getSimpleName())
                        .anyMatch(each -> calls(each, next) || calls(next, each) || isKindOf(each, next));
            }
        }
    }

    /** The reader pulls the bytes, and their values may be read anywhere; no other call leads back. */
    @Test
    void noFileLeadsBack() {
        for (int row = 1; row < path.size(); row++) {
            for (JavaClass later : path.get(row)) {
                assertThat(before(row).stream()
                                .filter(each -> !VALUES.contains(each.getName()))
                                .filter(each -> !(isReader(later) && isKindOf(each, named("Link"))))
                                .filter(each -> calls(later, each)))
                        .as("calls from %s", later.getSimpleName())
                        .isEmpty();
            }
        }
    }

    @Test
    void allBytesArePulledAndAllNoticesGivenInOnePlace() {
        assertThat(callers(Link.class, "receive"))
                .filteredOn(each -> !each.isAssignableTo(Link.class))
                .containsExactly(named(READER));
        assertThat(callers(SessionListener.class, "")).containsExactly(named(READER));
    }

    private static boolean isReader(JavaClass type) {
        return type.getSimpleName().equals(READER);
    }

    private static boolean isKindOf(JavaClass one, JavaClass other) {
        return one.isAssignableTo(other.getName()) || other.isAssignableTo(one.getName());
    }

    private static boolean calls(JavaClass from, JavaClass to) {
        return from.getMethodCallsFromSelf().stream()
                .anyMatch(call -> call.getTargetOwner().equals(to));
    }

    /** The classes that call a method of {@code type}; with an empty name, any method. */
    private static List<JavaClass> callers(Class<?> type, String method) {
        return CLASSES.stream()
                .filter(each -> each.getMethodCallsFromSelf().stream().anyMatch(call -> isOf(type, method, call)))
                .toList();
    }

    private static boolean isOf(Class<?> type, String method, JavaMethodCall call) {
        return call.getTargetOwner().isEquivalentTo(type)
                && (method.isEmpty() || call.getName().equals(method));
    }
}
