clock

clock foo

clock format 0 -gmt 1

clock format 0 -gmt 1 -format {%Y-%m-%d %H:%M:%S}

clock format 1700000000 -gmt 1 -format {%a %A %b %B %h %d %e %j %m %N %y %Y %C}

clock format 1700000000 -gmt 1 -format {%H %I %k %l %M %S %p %P %s}

clock format 1700000000 -gmt 1 -format {%u %w %U %V %W %G %g}

clock format 1700000000 -gmt 1 -format {%D|%T|%R|%r|%x|%X|%c|%+}

clock format 1700000000 -gmt 1 -format {%z %Z %% %n %t x}

clock format 1700000000 -gmt 1 -format {%J}

clock format 1700000000 -gmt 1 -format {%Ey %Od}

clock format 1700000000 -gmt 1 -format {%}

clock format 1700000000 -gmt 1 -format {%q}

clock format -1 -gmt 1

clock format 951782400 -gmt 1 -format %Y-%m-%d/%j

clock format 1704067199 -gmt 1 -format {%G-%V-%u %U %W}

clock format 1704067200 -gmt 1 -format {%G-%V-%u %U %W}

clock format 1609459200 -gmt 1 -format {%G-%V-%u %U %W %g}

clock format 946684799 -gmt 1 -format {%y %C %Y}

clock format 1700000000 -timezone +0100 -format {%H:%M %z}

clock format 1700000000 -timezone :America/New_York -format {%H:%M %z %Z}

clock format 1690000000 -timezone :Europe/Paris -format {%H:%M %z %Z}

clock format abc

clock format

clock format 0 -gmt

clock format 0 -foo 1

clock format 0 -gmt 1 -timezone :UTC

clock format 0 -timezone :No/Where

clock format 0 -gmt abc

clock format 43200 -gmt 1 -format {%I %l %p}

clock format 0 -gmt 1 -format {%I %l %p}

clock format 0 -gmt 1 -format ""

clock scan "1970-01-02" -gmt 1

clock scan "2023-11-14 22:13:20" -gmt 1

clock scan "20231114T221320" -gmt 1

clock scan "2023-11-14T22:13:20" -gmt 1

clock scan "11/14/2023" -gmt 1

clock scan "11/14/23" -gmt 1

clock scan "14 Nov 2023" -gmt 1

clock scan "Nov 14, 2023" -gmt 1

clock scan "Tue Nov 14 22:13:20 GMT 2023"

clock scan "10:30" -gmt 1 -base 0

clock scan "10:30 pm" -gmt 1 -base 0

clock scan "tomorrow" -gmt 1 -base 0

clock scan "yesterday" -gmt 1 -base 86400

clock scan "now" -gmt 1 -base 1234

clock scan "+1 day" -gmt 1 -base 0

clock scan "2 hours" -gmt 1 -base 0

clock scan "3 months" -gmt 1 -base 0

clock scan "2023-11-14" -format %Y-%m-%d -gmt 1

clock scan "14/11/2023 10:20:30" -format {%d/%m/%Y %H:%M:%S} -gmt 1

clock scan "14 November 2023" -format {%d %B %Y} -gmt 1

clock scan "Nov 5 2023" -format {%b %d %Y} -gmt 1

clock scan "10:20 PM" -format {%I:%M %p} -gmt 1 -base 0

clock scan "1234567890" -format %s

clock scan "2023-11-14 +0100" -format {%Y-%m-%d %z}

clock scan "2023-320" -format %Y-%j -gmt 1

clock scan "foo" -format %Y -gmt 1

clock scan "23-1-2" -format %y-%m-%d -gmt 1

clock scan "2023-11-14 x" -format %Y-%m-%d -gmt 1

clock scan

clock scan x -foo y

clock add 0 1 day -gmt 1

clock add 0 1 month -gmt 1

clock add 0 1 year 2 hours -gmt 1

clock add 2678400 1 month -gmt 1

clock add 0 -1 week -gmt 1

clock add 0 90 minutes

clock add 0 5 seconds

clock add 0 1 foo

clock add 0 1

clock add

clock seconds x

expr {[clock seconds] > 1600000000}

expr {[clock milliseconds] / 1000 - [clock seconds] < 2}

expr {[clock microseconds] > 1600000000000000}

expr {[clock clicks] != 0}

expr {[clock clicks -milliseconds] > 0}

clock clicks -foo

clock clicks a b

clock milliseconds x
