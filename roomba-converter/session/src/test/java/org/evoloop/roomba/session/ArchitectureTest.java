package org.evoloop.roomba.session;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.base.DescribedPredicate.or;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;

/** The session's packages; its module-info says which other modules it may use, of the core only some packages. */
@AnalyzeClasses(packages = "org.evoloop.roomba.session", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final String OI = "org.evoloop.roomba.oi..";
    private static final String LINK = "org.evoloop.link..";
    private static final String TIME = "org.evoloop.time..";

    private static ArchRule room(String room, DescribedPredicate<JavaClass> mayUse) {
        return classes()
                .that()
                .resideInAPackage(room)
                .should()
                .onlyDependOnClassesThat(or(resideInAPackage(room), mayUse, not(resideInAPackage("org.evoloop.."))));
    }

    @ArchTest
    static final ArchRule theSessionKnowsTheRobotOnly = room(
            "org.evoloop.roomba.session..",
            or(resideInAnyPackage(OI, LINK, TIME), type(DeviceLink.class), type(Reading.class)));

    @ArchTest
    static final ArchRule aConnectionKnowsNothingOfItsSession =
            room("org.evoloop.roomba.session.connection..", resideInAnyPackage(OI, LINK, TIME));

    @ArchTest
    static final ArchRule whatFramesTellIsPure = room("org.evoloop.roomba.session.inference..", resideInAPackage(OI));
}
