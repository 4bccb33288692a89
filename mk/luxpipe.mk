# SPDX-License-Identifier: BSD-3-Clause
# Rules for studies: pictures and their metrics, each made once and again when something it was made of has changed.
# See luxpipe-mk(7).  A Makefile says
#     include luxpipe.mk
#     $(eval $(call luxpipe_picture,out/office_0900,-vf view.vf materials.rad room.rad sky_0900.rad))
#     table.tsv: $(luxpipe_metrics) ; $(luxpipe_join) > $@
# A picture out/office_0900.exr and its line of metrics out/office_0900.tsv come from each such call.
FRAMES  ?= 64
SIZE    ?= 256
METRICS ?= Ev,DGPf,RAMMG
# Certainty of the intervals beside each metric (NAME.lo, NAME.hi), which the kept picture has; empty: no intervals.
CERTAINTY ?= 95
# With UNTIL='DGPf 1%, Ev 0.5%' a picture is ready when the rule of vcmetrics holds, after at most FRAMES frames.
UNTIL   ?=
# no: a picture whose rule did not hold (status 4) is not made.  yes: it is kept as it is.
UNSETTLED ?= no

PTRACE    ?= ptrace -w-
PTACCUM   ?= ptaccum
VCMETRICS ?= vcmetrics -W-

# A pipe fails with any of its programs, and what a failed rule left is removed.
SHELL := bash
.SHELLFLAGS := -eo pipefail -c
.DELETE_ON_ERROR:

luxpipe_pictures :=
luxpipe_metrics :=

# $(call luxpipe_picture,NAME,WORDS): WORDS are ptrace's options and scene files.  NAME.d is the rule of make that lists
# what the picture was made of, NAME.words the words: when one of them changes, so does the picture.
define luxpipe_picture
luxpipe_pictures += $(1).exr
luxpipe_metrics += $(1).tsv
ifneq ($$(strip $$(file <$(1).words)),$(strip -x $(SIZE) -y $(SIZE) -frames $(FRAMES) $(2) $(UNTIL)))
$$(shell mkdir -p $(dir $(1)))
$$(file >$(1).words,$(strip -x $(SIZE) -y $(SIZE) -frames $(FRAMES) $(2) $(UNTIL)))
endif
$(1).exr: $(1).words
	$$(call luxpipe_render,$(1),$(2))
	mv $(1).part.exr $$@
$(1).tsv: $(1).exr
	$$(VCMETRICS) -metrics $$(METRICS) $$(if $$(CERTAINTY),-ci $$(CERTAINTY)) $$< > $$@
-include $(1).d
endef

# The rule is written by the rendering itself, which reads the scene anyway.
luxpipe_frames = $(PTRACE) -M $(1).exr -MF $(1).d -x $(SIZE) -y $(SIZE) -frames $(FRAMES) $(2)
ifeq ($(strip $(UNTIL)),)
luxpipe_render = $(luxpipe_frames) | $(PTACCUM) -last -o $(1).part.exr
else
luxpipe_render = $(luxpipe_frames) | $(PTACCUM) -o $(1).part.exr -o - | \
	$(VCMETRICS) -metrics $(METRICS) -until '$(UNTIL)' > $(1).log $(if $(filter yes,$(UNSETTLED)),|| [ $$? = 4 ])
endif

# All lines of metrics under one line of names.
luxpipe_join = awk 'FNR > 1 || NR == 1' $(luxpipe_metrics)
